// SPDX-License-Identifier: MIT
// The polygons that witnesses cull, frame by frame.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "occlude/culler/hierarchy.h"

namespace occlude::cli {

/// Triangles [first, first + count) in the order of the culler's tree.
struct CulledRun {
  std::size_t first = 0, count = 0;
  std::size_t witness = 0;  ///< the number of its line, from 1
};

using CulledSets = std::map<std::size_t, std::vector<CulledRun>>;  ///< by frame

/// For each polygon of the tree, whether any of its triangles is drawn.
[[nodiscard]] std::vector<bool> drawn_polygons(const culler::Hierarchy& hierarchy, const std::vector<CulledRun>& culled);

/// The number of a witness that culls a triangle of polygon p of the tree, or 0.
[[nodiscard]] std::size_t witness_of(const culler::Hierarchy& hierarchy, const std::vector<CulledRun>& culled,
                                     std::size_t p);

}  // namespace occlude::cli
