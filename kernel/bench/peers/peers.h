// SPDX-License-Identifier: MIT
// Other projects' answers to the same question, each measured where its library is installed.
#pragma once

#include <string>
#include <vector>

#include "subject.h"

namespace occlude::bench {

struct Peer {
  std::string name, version;
  std::vector<Subject> subjects;  ///< the ways in which it can be asked
};

/// Those that are installed.
[[nodiscard]] std::vector<Peer> peers();

// One a file, which is compiled where the library was found.
[[nodiscard]] std::vector<Subject> libccd_subjects();
[[nodiscard]] std::vector<Subject> fcl_subjects();
[[nodiscard]] std::vector<Subject> bullet_subjects();
[[nodiscard]] std::vector<Subject> osg_subjects();

}  // namespace occlude::bench
