// SPDX-License-Identifier: MIT
// Convex polygons cut by half-spaces, without divisions.
#pragma once

#include <vector>

#include "plane.h"

namespace occlude::oracle {

/// The point x / w, w > 0.
template <class N>
struct Homogeneous {
  Vector<N> x;
  N w;
};

/// The part of a convex polygon, which may be a segment or a point, in the half-space. Corners may be repeated.
template <class N>
std::vector<Homogeneous<N>> clipped(const std::vector<Homogeneous<N>>& polygon, const HalfSpace<N>& half_space) {
  const auto height = [&](const Homogeneous<N>& q) {
    return N(half_space.normal * (q.x - q.w * half_space.point) + q.w * half_space.offset);
  };
  std::vector<Homogeneous<N>> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Homogeneous<N>&p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const N a = height(p), b = height(q);
    const CGAL::Sign of_a = certain_sign(a), of_b = certain_sign(b);
    if (of_a != CGAL::NEGATIVE) result.push_back(p);
    if (of_a == -of_b && of_a == CGAL::POSITIVE) result.push_back({a * q.x - b * p.x, a * q.w - b * p.w});
    if (of_a == -of_b && of_a == CGAL::NEGATIVE) result.push_back({b * p.x - a * q.x, b * p.w - a * q.w});
  }
  return result;
}

}  // namespace occlude::oracle
