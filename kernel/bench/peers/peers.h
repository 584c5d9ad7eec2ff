// SPDX-License-Identifier: MIT
// Other projects' answers to the same question. Each is measured where its library is installed.
#pragma once

#include <string>
#include <vector>

#include "subject.h"

namespace occlude::bench {

struct Peer {
  std::string name, version;
  std::vector<Subject> subjects;  ///< the ways in which the library can be asked
};

/// The peers that are installed.
[[nodiscard]] std::vector<Peer> peers();

// Each of these is in a file of its own, which is compiled where its library was found.
[[nodiscard]] std::vector<Subject> libccd_subjects();
[[nodiscard]] std::vector<Subject> fcl_subjects();
[[nodiscard]] std::vector<Subject> bullet_subjects();
[[nodiscard]] std::vector<Subject> osg_subjects();

}  // namespace occlude::bench
