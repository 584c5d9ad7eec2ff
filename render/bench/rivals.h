// SPDX-License-Identifier: MIT
// Other projects that tell what is visible. A module of its own, which lies beside the program and is loaded for the
// benchmark alone, is linked with their libraries, so that the program is not.
#pragma once

#include <vector>

#include "occlude/culler/hierarchy.h"
#include "peer_results.h"
#include "visibility_way.h"

namespace occlude::experiments {

/// Pixels, with a ray through the middle of each.
struct RayPicture {
  int width, height;
};

struct Rival {
  bench::PeerSummary project;
  std::vector<UnpreparedWay> ways;
};

/// All known rivals, installed or not. Their ways tell which leaves of the tree, and it must outlive them. Those that cast
/// rays have a way for each of the pictures.
[[nodiscard]] std::vector<Rival> rivals(const culler::Hierarchy& tree, const std::vector<RayPicture>& pictures);

// Of the module; the build defines the version of each library that it found. Each of these is in a file of its own.

[[nodiscard]] std::vector<UnpreparedWay> embree_ways(const culler::Hierarchy& tree, const std::vector<RayPicture>& pictures);
[[nodiscard]] std::vector<UnpreparedWay> osg_ways(const culler::Hierarchy& tree);

/// The one function that the module exports: appends the rivals that are installed.
inline constexpr const char* kAppendRivals = "occlude_append_rivals";
using AppendRivals = void(const culler::Hierarchy& tree, const std::vector<RayPicture>& pictures,
                          std::vector<Rival>& rivals);

}  // namespace occlude::experiments
