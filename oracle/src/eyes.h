// SPDX-License-Identifier: MIT
// A region of eyes, in either number type.
#pragma once

#include <algorithm>
#include <vector>

#include "occlude/oracle/region.h"
#include "plane.h"

namespace occlude::oracle {

/// The points no farther than `radius` from the hull of `corners`.
template <class N>
struct Eyes {
  std::vector<Vector<N>> corners;
  N radius = N(0);
  bool is_round = false;  ///< whether the radius is not zero
};

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

template <class N>
Eyes<N> eyes_of(const EyeRegion& region) {
  if (const Obb* box = std::get_if<Obb>(&region)) return {corners_of<N>(*box), N(0), false};
  const auto& [center, radius] = std::get<Ball>(region);
  return {{vector_of<N>(center)}, N(radius), radius > 0};
}

/// The sign of the least height of an eye over the half-space. Squares are compared, so no root is needed.
template <class N>
CGAL::Sign least_side(const Eyes<N>& eyes, const HalfSpace<N>& half_space) {
  CGAL::Sign least = CGAL::POSITIVE;
  for (const Vector<N>& corner : eyes.corners) {
    const N height = half_space.height(corner);
    CGAL::Sign side = certain_sign(height);
    if (eyes.is_round && side != CGAL::NEGATIVE) {
      side = certain_sign(N(height * height - eyes.radius * eyes.radius * (half_space.normal * half_space.normal)));
    }
    least = std::min(least, side);
  }
  return least;
}

}  // namespace occlude::oracle
