// SPDX-License-Identifier: MIT
// A box by its corners, and as a cube in coordinates of its own: x, y, z of an axis-aligned box between its min and max, the
// factors of the half edges of an oriented one between -1 and 1.
#pragma once

#include "feasibility.h"
#include "plane.h"

namespace occlude::oracle {

inline constexpr unsigned kCorners = 8;

/// Corner `index` of a box: bit k set when it is at the high end of the box's own coordinate k.
struct Corner {
  const Box& box;
  unsigned index;

  [[nodiscard]] bool is_high(unsigned k) const { return (index >> k & 1U) != 0; }
};

template <class N>
Vector<N> vector_of(const Corner& corner) {
  if (const Aabb* aabb = std::get_if<Aabb>(&corner.box)) {
    const auto coordinate = [&](unsigned k) { return N(corner.is_high(k) ? aabb->max[k] : aabb->min[k]); };
    return {coordinate(0), coordinate(1), coordinate(2)};
  }
  const Obb& obb = std::get<Obb>(corner.box);
  Vector<N> x = vector_of<N>(obb.center);
  for (unsigned k = 0; k < 3; ++k) {
    const Vector<N> half_edge = vector_of<N>(obb.half_edges[k]);
    x = corner.is_high(k) ? x + half_edge : x - half_edge;
  }
  return x;
}

/// The range of the box's own coordinates.
[[nodiscard]] Bounds<3> own_bounds(const Box& box);

/// The half-space in the box's own coordinates.
[[nodiscard]] Inequality<3> in_own_coordinates(const HalfSpace<Exact>& half_space, const Box& box);

}  // namespace occlude::oracle
