// SPDX-License-Identifier: MIT
// Adjacency found in the soup: which sides of its polygons run along one edge.
#pragma once

#include <cstdint>
#include <vector>

#include "occlude/culler/polygon_soup.h"

namespace occlude::culler {

/// Side s runs from the vertex soup.indices[s] to the next of the same loop.
struct SidePair {
  double length;  ///< squared
  std::uint32_t side, twin;
};

/// The polygon of each side.
[[nodiscard]] std::vector<std::uint32_t> polygon_of_sides(const PolygonSoup& soup);

/// Sides along one edge in opposite directions, with no third there, by equal coordinates: the longest first.
[[nodiscard]] std::vector<SidePair> find_adjacency(const PolygonSoup& soup);

}  // namespace occlude::culler
