// SPDX-License-Identifier: MIT
// Adjacency found in the soup: which sides of its polygons run along the same edge.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "occlude/culler/executor.h"
#include "occlude/culler/polygon_soup.h"

namespace occlude::culler {

/// Two sides that run along the same edge. Side s runs from the vertex soup.indices[s] to the next vertex of its loop.
struct SidePair {
  double length;  ///< squared
  std::uint32_t side, twin;
};

/// The polygon of each side.
[[nodiscard]] std::vector<std::uint32_t> polygon_of_sides(SoupView soup);

/// For each vertex, the first vertex with the same coordinates.
[[nodiscard]] std::vector<std::uint32_t> welded(std::span<const glm::dvec3> vertices, const Checkpoint& checkpoint = {});

/// The pairs of sides that run along one edge in opposite directions, where no third side runs along it, the longest first.
/// `weld` is the result of welded(): vertices with equal coordinates count as one.
[[nodiscard]] std::vector<SidePair> find_adjacency(SoupView soup, std::span<const std::uint32_t> weld,
                                                   const Checkpoint& checkpoint = {});

/// For each polygon, whether it and an earlier one are opaque and have the same corners in the same order, in either
/// orientation. Such a polygon hides only what the earlier one hides.
[[nodiscard]] std::vector<bool> find_repeated(SoupView soup, std::span<const std::uint32_t> weld,
                                              const Checkpoint& checkpoint = {});

}  // namespace occlude::culler
