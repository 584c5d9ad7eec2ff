// SPDX-License-Identifier: MIT
// A box by its corners, and as a cube in its own coordinates. For an axis-aligned box these are x, y, z between min and max.
// For an oriented box they are the factors of its half edges, between -1 and 1.
#pragma once

#include <algorithm>
#include <optional>

#include "feasibility.h"
#include "plane.h"

namespace occlude::oracle {

/// The corners of a box. Bit k of corner c is set when it is at the high end of the box's own coordinate k.
inline constexpr unsigned kCorners = 8;

/// One number for each corner.
template <class N>
using OfCorners = std::array<N, kCorners>;

/// The terms that the low and the high end of own coordinate `k` add to the height of a corner over the half-space.
template <class N>
std::array<N, 2> shares(const HalfSpace<N>& half_space, const Aabb& box, unsigned k) {
  const int axis = static_cast<int>(k);
  const auto share = [&](double x) { return N(half_space.normal[axis] * (N(x) - half_space.point[axis])); };
  return {share(box.min[k]), share(box.max[k])};
}

template <class N>
std::array<N, 2> shares(const HalfSpace<N>& half_space, const Obb& box, unsigned k) {
  const N high = half_space.normal * vector_of<N>(box.half_edges[k]);
  return {-high, high};
}

/// The term that the heights of all corners share.
template <class N>
N common_share(const HalfSpace<N>& half_space, const Aabb&) {
  return half_space.offset;
}

template <class N>
N common_share(const HalfSpace<N>& half_space, const Obb& box) {
  return half_space.height(box.center);
}

/// The heights of the corners over the half-space, each the distance times the length of the normal.
template <class N>
OfCorners<N> corner_heights(const HalfSpace<N>& half_space, const Box& box) {
  return std::visit(
      [&](const auto& kind) {
        OfCorners<N> heights;
        heights[0] = common_share(half_space, kind);
        for (unsigned k = 0; k < 3; ++k) {
          const auto [low, high] = shares(half_space, kind, k);
          for (unsigned c = 1U << k; c-- > 0;) {
            heights[c | 1U << k] = heights[c] + high;
            heights[c] += low;
          }
        }
        return heights;
      },
      box);
}

/// The side of the plane on which each corner lies, exactly.
template <class Definition>
OfCorners<CGAL::Sign> corner_sides(Plane<Definition>& plane, const Box& box) {
  const OfCorners<Interval> approximate = corner_heights(plane.template in<Interval>(), box);
  std::optional<OfCorners<Exact>> exact;
  OfCorners<CGAL::Sign> sides;
  for (unsigned c = 0; c < kCorners; ++c) {
    const CGAL::Uncertain<CGAL::Sign> side = CGAL::sign(approximate[c]);
    if (!CGAL::is_certain(side) && !exact) exact = corner_heights(plane.template in<Exact>(), box);
    sides[c] = CGAL::is_certain(side) ? CGAL::get_certain(side) : CGAL::sign((*exact)[c]);
  }
  return sides;
}

/// Whether every corner is at least `distance` away from the plane, exactly. Squares are compared, so no root is needed.
template <class Definition>
bool keeps_distance(Plane<Definition>& plane, const Box& box, double distance) {
  return distance == 0 || decide([&]<class N>() {
           const HalfSpace<N>& half_space = plane.template in<N>();
           const N least = N(distance) * N(distance) * (half_space.normal * half_space.normal);
           return std::ranges::all_of(corner_heights(half_space, box), [&](const N& height) {
             return certain_sign(N(height * height - least)) != CGAL::NEGATIVE;
           });
         });
}

/// The range of the box's own coordinates.
template <class N>
Bounds<N, 3> own_bounds(const Box& box) {
  const auto tuple = [](const Point& p) { return std::array{N(p[0]), N(p[1]), N(p[2])}; };
  if (const Aabb* aabb = std::get_if<Aabb>(&box)) return {tuple(aabb->min), tuple(aabb->max)};
  return {tuple({-1, -1, -1}), tuple({1, 1, 1})};
}

/// The half-space as an inequality in the box's own coordinates.
template <class N>
Inequality<N, 3> in_own_coordinates(const HalfSpace<N>& half_space, const Box& box) {
  const Vector<N>& n = half_space.normal;
  if (std::holds_alternative<Aabb>(box)) return {{-n.x(), -n.y(), -n.z()}, half_space.offset - n * half_space.point};
  const Obb& obb = std::get<Obb>(box);
  const auto steepness = [&](std::size_t k) { return N(-(n * vector_of<N>(obb.half_edges[k]))); };
  return {{steepness(0), steepness(1), steepness(2)}, half_space.height(obb.center)};
}

}  // namespace occlude::oracle
