// SPDX-License-Identifier: MIT
// What witnesses say is culled, frame by frame.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "occlude/culler/hierarchy.h"

namespace occlude::cli {

/// Triangles [first, first + count) in the order of the culler's tree.
struct CulledRun {
  std::size_t first = 0, count = 0;
  std::size_t witness = 0;  ///< number of its line, from 1
};

using CulledSets = std::map<std::size_t, std::vector<CulledRun>>;  ///< by frame

/// Of each polygon of the tree whether any of its triangles is drawn.
[[nodiscard]] std::vector<bool> drawn_polygons(const culler::Hierarchy& hierarchy, const std::vector<CulledRun>& culled);

/// The witness that has culled polygon p of the tree; 0 if none has.
[[nodiscard]] std::size_t witness_of(const culler::Hierarchy& hierarchy, const std::vector<CulledRun>& culled,
                                     std::size_t p);

}  // namespace occlude::cli
