// SPDX-License-Identifier: MIT
// Adjacency found in the soup: which sides of its polygons run along one edge.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "occlude/culler/checkpoint.h"
#include "occlude/culler/polygon_soup.h"

namespace occlude::culler {

/// Side s runs from the vertex soup.indices[s] to the next of the same loop.
struct SidePair {
  double length;  ///< squared
  std::uint32_t side, twin;
};

/// The polygon of each side.
[[nodiscard]] std::vector<std::uint32_t> polygon_of_sides(const PolygonSoup& soup);

/// Of each vertex the first with the same coordinates.
[[nodiscard]] std::vector<std::uint32_t> welded(const std::vector<glm::dvec3>& vertices, const Checkpoint& checkpoint = {});

/// Sides along one edge in opposite directions, with no third there, by equal coordinates: the longest first. `weld` is what
/// welded() makes of the vertices.
[[nodiscard]] std::vector<SidePair> find_adjacency(const PolygonSoup& soup, std::span<const std::uint32_t> weld,
                                                   const Checkpoint& checkpoint = {});

/// Of each polygon whether one before it has the same corners in the same order, either way round: it hides what that one
/// hides.
[[nodiscard]] std::vector<bool> find_repeated(const PolygonSoup& soup, std::span<const std::uint32_t> weld,
                                              const Checkpoint& checkpoint = {});

}  // namespace occlude::culler
