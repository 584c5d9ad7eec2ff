// SPDX-License-Identifier: MIT
// Stage 1 of the overlap test (section 5.3): the box against each plane by its two extremal vertices. Reading order: 7.
//
// The normal of a plane picks the vertex of the box farthest along it and the one nearest. The two values there decide what
// all eight would.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "box_frame.h"
#include "occlude/kernel/overlap.h"
#include "plane_coefficients.h"

namespace occlude::kernel {

/// The vertex of the box farthest along a direction with these signs.
[[nodiscard]] inline Vec3 extremal_vertex(const Aabb& box, bool positive_x, bool positive_y, bool positive_z) {
  return {positive_x ? box.max.x : box.min.x, positive_y ? box.max.y : box.min.y, positive_z ? box.max.z : box.min.z};
}

/// Sign of the plane at the extremal vertex of the box along its normal: the nearest (`direction` = -1) or the farthest (1).
template <class A>
[[nodiscard]] int extremal_sign(A& arithmetic, const PlaneCoefficients<A>& plane, const Vec3& origin, const Aabb& box,
                                int direction) {
  const auto positive = [&](int axis) { return direction * arithmetic.sign(plane.normal[axis]) >= 0; };
  const Vec3 vertex = extremal_vertex(box, positive(0), positive(1), positive(2));
  return arithmetic.sign(dot(plane.normal, difference<A>(vertex, origin)) + plane.offset);
}
template <class A>
[[nodiscard]] int extremal_sign(A& arithmetic, const PlaneCoefficients<A>& plane, const Vec3& origin, const Obb& box,
                                int direction) {
  auto value = dot(plane.normal, difference<A>(box.center, origin)) + plane.offset;
  for (const Vec3& half_edge : box.half_edges) {
    const auto spread = A::magnitude(dot(plane.normal, constants<A>(half_edge)));
    value = direction > 0 ? value + spread : value - spread;
  }
  return arithmetic.sign(value);
}

/// Exact sign of plane `i` of the frustum at the extremal vertex of the box, where the filter could not tell.
[[nodiscard]] int exact_extremal_sign(const StoredFrustum& frustum, std::size_t i, const Aabb& box, double reach,
                                      int direction);
[[nodiscard]] int exact_extremal_sign(const StoredFrustum& frustum, std::size_t i, const Obb& box, double reach,
                                      int direction);

/// The stage from plane `first` on, where the filter cannot tell. Each plane before it has the box on its inner side, or
/// `straddling` is set. This function is separate from the filter's own loop because it would slow the loop down.
template <class Box, class Frame>
[[nodiscard, gnu::noinline]] Decision box_planes_resolved(const StoredFrustum& frustum, const Box& box, const Frame& frame,
                                                          NearBoundary near, std::size_t first, bool straddling) {
  const double error = frame.error(frustum.filter_bound);
  for (std::size_t i = first; i < frustum.plane_count; ++i) {
    const auto extremes = frame.extremes(frustum.filter_planes[i]);
    const double high = extremes.high(), low = extremes.low();
    if (high < -error) return {Relation::outside, Stage::exact};
    if (low > error) continue;
    if (high <= error && exact_extremal_sign(frustum, i, box, frame.reach(), 1) < 0)
      return {Relation::outside, Stage::exact};
    const int least_inner = near == NearBoundary::open && i < frustum.near_count ? 1 : 0;
    straddling = straddling || low < -error || exact_extremal_sign(frustum, i, box, frame.reach(), -1) < least_inner;
  }
  return {straddling ? Relation::partial : Relation::inside, Stage::exact};
}

/// The whole stage, certified: every answer is exact, and comes from the filter where its error bounds suffice. `frame` is
/// the frame of the box.
template <class Box, class Frame>
[[nodiscard, gnu::always_inline]] inline Decision box_planes_certified(const StoredFrustum& frustum, const Box& box,
                                                                       const Frame& frame, NearBoundary near) {
  const auto planes = frustum.own_planes();
  const double error = frame.error(frustum.filter_bound);
  double least_low = HUGE_VAL;  // no branch here: no predictor could tell inner from straddling
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const auto extremes = frame.extremes(planes[i]);
    const double low = extremes.low(), high = extremes.high();
    if (high < -error) return {Relation::outside, Stage::filter};
    if (!(std::fabs(low) > error && high > error)) [[unlikely]] {
      return box_planes_resolved(frustum, box, frame, near, i, least_low < 0);
    }
    least_low = std::min(least_low, low);
  }
  return {least_low < 0 ? Relation::partial : Relation::inside, Stage::filter};
}

}  // namespace occlude::kernel
