// SPDX-License-Identifier: MIT
// Stage 1 of the overlap test (section 5.3): the box against each plane by its two extremal vertices. Reading order: 6.
//
// The normal of a plane picks the vertex of the box farthest along it and the one nearest: two values decide what eight
// would.
#pragma once

#include <algorithm>
#include <cmath>

#include "occlude/kernel/overlap.h"
#include "plane_value.h"

namespace occlude::kernel {

/// The vertex of the box farthest along a direction with these signs.
[[nodiscard]] inline Vec3 extremal_vertex(const Aabb& box, bool positive_x, bool positive_y, bool positive_z) {
  return {positive_x ? box.max.x : box.min.x, positive_y ? box.max.y : box.min.y, positive_z ? box.max.z : box.min.z};
}

/// Values of a rounded plane at the extremal vertices of the box, nearest and farthest along its normal.
template <class A>
struct ExtremalValues {
  typename A::Number low, high;

  ExtremalValues(const FilterPlane& plane, const Aabb& box) {
    const bool x = plane.normal.x >= 0, y = plane.normal.y >= 0, z = plane.normal.z >= 0;
    const Vector3<typename A::Number> n{A::constant(plane.normal.x), A::constant(plane.normal.y),
                                        A::constant(plane.normal.z)};
    low = dot(n, difference<A>(extremal_vertex(box, !x, !y, !z), plane.origin));
    high = dot(n, difference<A>(extremal_vertex(box, x, y, z), plane.origin));
  }
};

/// The whole stage in plain double arithmetic. `A` is PlainArithmetic or CountingArithmetic.
template <class A>
[[nodiscard]] Relation box_planes_plain(const ShadowFrustum& frustum, const Aabb& box, NearBoundary near) {
  bool inside = true;
  int least_inner = near == NearBoundary::open ? 1 : 0;  // of the near plane, the first; touching the others is inside
  for (const FilterPlane& plane : frustum.filter_planes()) {
    const ExtremalValues<A> values(plane, box);
    if (A::sign(values.high) < 0) return Relation::outside;
    inside = inside && A::sign(values.low) >= least_inner;
    least_inner = 0;
  }
  return inside ? Relation::inside : Relation::partial;
}

/// The whole stage, certified: true answers, by the filter where its error bounds suffice.
[[nodiscard]] Decision box_planes_certified(const ShadowFrustum& frustum, const Aabb& box, NearBoundary near);

}  // namespace occlude::kernel
