// SPDX-License-Identifier: MIT
// The corners of a box, in either number type.
#pragma once

#include <vector>

#include "numbers.h"

namespace occlude::oracle {

/// The corners of a box. Half edges of zero do not double them.
template <class N>
std::vector<Vector<N>> corners_of(const Obb& box) {
  std::vector<Vector<N>> corners{vector_of<N>(box.center)};
  for (const Point& half_edge : box.half_edges) {
    if (half_edge == Point{}) continue;
    const std::size_t size = corners.size();
    for (std::size_t i = 0; i < size; ++i) {
      corners.push_back(corners[i] + vector_of<N>(half_edge));
      corners[i] = corners[i] - vector_of<N>(half_edge);
    }
  }
  return corners;
}

template <class N>
std::vector<Vector<N>> corners_of(const Aabb& box) {
  std::vector<Vector<N>> corners;
  for (unsigned c = 0; c < 8; ++c) {
    const auto end = [&](unsigned k) { return ((c >> k & 1U) != 0 ? box.max : box.min)[k]; };
    corners.push_back(vector_of<N>({end(0), end(1), end(2)}));
  }
  return corners;
}

}  // namespace occlude::oracle
