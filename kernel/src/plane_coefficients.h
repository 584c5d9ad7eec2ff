// SPDX-License-Identifier: MIT
// Computes the coefficients of a plane from input coordinates, in any arithmetic.
#pragma once

#include <optional>

#include "arithmetic.h"
#include "grid_sign.h"
#include "stored_frustum.h"
#include "vector3.h"

namespace occlude::kernel {

template <class A>
[[nodiscard]] Vector3<typename A::Number> normal(const ExactPlane& plane) {
  const auto a = difference<A>(plane.a_to, plane.a_from);
  return plane.direct ? a : cross_of_differences(a, difference<A>(plane.b_to, plane.b_from));
}

template <class A>
[[nodiscard]] typename A::Number value(const ExactPlane& plane, const Vec3& x) {
  return dot(normal<A>(plane), difference<A>(x, plane.origin));
}

/// Whether x is a point that the plane was laid through. The value there is zero without any arithmetic, which would have to
/// be exact to find it. Shared vertices are the most common degeneracy.
[[nodiscard]] inline bool is_defined_by(const ExactPlane& plane, const Vec3& x) {
  if (x == plane.origin) return true;
  if (plane.direct) return false;
  return (x == plane.a_to && plane.a_from == plane.origin) || (x == plane.b_to && plane.b_from == plane.origin);
}

/// The sign at x of a plane that is exactly perpendicular to a coordinate axis. The signs of `normal` are those of its own.
/// Boxes that touch such planes are the most common degeneracy of what is built along the axes.
[[nodiscard]] inline std::optional<int> sign_across_axis(const ExactPlane& plane, const Vec3& normal, const Vec3& x) {
  if (plane.direct) return std::nullopt;
  for (int k = 0; k < 3; ++k) {
    if (plane.a_to[k] != plane.a_from[k] || plane.b_to[k] != plane.b_from[k]) continue;
    const int side = (x[k] > plane.origin[k]) - (x[k] < plane.origin[k]);
    if (normal[k] == 0) return std::nullopt;  // it underflowed
    return normal[k] > 0 ? side : -side;
  }
  return std::nullopt;
}

/// Exact sign of the plane at x: 1 on the inner side, 0 on the plane, -1 on the outer side.
[[nodiscard]] inline int sign_at(const ExactPlane& plane, const Vec3& x, Stage* stage = nullptr) {
  if (is_defined_by(plane, x)) return 0;
  const auto question = [&]<class A>(A& arithmetic) { return arithmetic.sign(value<A>(plane, x)); };
  FilterArithmetic filter;
  const int sign = question(filter);
  if (!filter.failed()) return sign;
  if (stage) *stage = Stage::exact;
  if (const std::optional<int> on_grid = grid_sign(plane, x)) return *on_grid;
  return exactly(question);
}

/// f(x) = normal . (x - origin of the frustum) + offset.
template <class A>
struct PlaneCoefficients {
  Vector3<typename A::Number> normal;
  typename A::Number offset;
};

/// The direction of the frustum's edge through a corner of the silhouette, away from the viewpoint.
template <class A>
[[nodiscard]] Vector3<typename A::Number> ray(const StoredFrustum& frustum, std::size_t corner) {
  const Viewpoint& viewpoint = frustum.viewpoint;
  return viewpoint.is_eye() ? difference<A>(frustum.silhouette[corner], viewpoint.value) : constants<A>(viewpoint.value);
}

template <class A>
[[nodiscard]] PlaneCoefficients<A> coefficients(const StoredFrustum& frustum, const ExactPlane& plane) {
  const auto n = normal<A>(plane);
  if (plane.origin == frustum.origin) return {n, A::constant(0)};
  return {n, -dot(n, difference<A>(plane.origin, frustum.origin))};
}

/// The plane of the near side of a frustum that is cut, and side planes.
[[nodiscard]] inline const ExactPlane& plane_of(const StoredFrustum& frustum, std::size_t plane) {
  return std::get<ExactPlane>(frustum.recipes[plane]);
}

template <class A>
[[nodiscard]] PlaneCoefficients<A> coefficients(const StoredFrustum& frustum, const CutEdgePlane& plane) {
  const auto near = coefficients<A>(frustum, plane_of(frustum, 0));
  const auto side = coefficients<A>(frustum, plane_of(frustum, plane.side));
  const auto axis = constants<A>(plane.axis);
  const auto along_near = A::magnitude(dot(near.normal, axis)), along_side = A::magnitude(dot(side.normal, axis));
  return {along_side * near.normal + along_near * side.normal, along_side * near.offset + along_near * side.offset};
}

/// On the ray corner + t d the near plane has the value f_near(corner) + t N . d. So the ray meets the near plane in the
/// point corner - f_near(corner) / (N . d) d. The coefficients are those of the plane through this point, times N . d, which
/// is positive.
template <class A>
[[nodiscard]] PlaneCoefficients<A> coefficients(const StoredFrustum& frustum, const CutVertexPlane& plane) {
  const ExactPlane& near = plane_of(frustum, 0);
  const auto near_normal = normal<A>(near);
  const auto d = ray<A>(frustum, plane.corner);
  const auto face = coefficients<A>(frustum, plane.face);
  const auto speed = dot(near_normal, d);
  const auto at_corner = dot(near_normal, difference<A>(plane.face.origin, near.origin));
  return {speed * face.normal, speed * face.offset + at_corner * dot(face.normal, d)};
}

/// The line of sight from a corner of a region to a point, away from the viewer.
template <class A>
[[nodiscard]] Vector3<typename A::Number> sight(const RegionCorner& corner, const Vec3& point) {
  auto sum = corner.is_eye ? difference<A>(point, corner.at) : constants<A>(corner.at);
  for (const Vec3& move : corner.moves) {
    sum = corner.is_eye ? sum - constants<A>(move) : sum + constants<A>(move);
  }
  return sum;
}

template <class A>
[[nodiscard]] Vector3<typename A::Number> normal(const SightPlane& plane) {
  return cross(sight<A>(plane.corner, plane.point), difference<A>(plane.to, plane.from));
}

template <class A>
[[nodiscard]] PlaneCoefficients<A> coefficients(const StoredFrustum& frustum, const SightPlane& plane) {
  const auto n = normal<A>(plane);
  return {n, -dot(n, difference<A>(plane.point, frustum.origin))};
}

template <class A>
[[nodiscard]] PlaneCoefficients<A> coefficients(const StoredFrustum& frustum, const PlaneRecipe& recipe) {
  return std::visit([&](const auto& plane) { return coefficients<A>(frustum, plane); }, recipe);
}

}  // namespace occlude::kernel
