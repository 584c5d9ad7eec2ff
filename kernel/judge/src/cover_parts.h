// SPDX-License-Identifier: MIT
// A set of polygons in the plane of rays: triangles with an area there, and arcs. An arc is all that is seen of what is
// edge-on.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "binary_parts.h"
#include "occlude/kernel/half_space.h"
#include "rays.h"

namespace occlude::kernel {

/// The plane of a triangle. Its point on a ray has the nearness of_ray . ray / unit, where unit > 0.
template <class Number>
struct PlaneForm {
  Vector3<Number> of_ray;
  Number unit;
};

/// A triangle whose corners turn counter-clockwise in the plane of rays. Its rays are those that are negative on none of its
/// sides.
template <class Number>
struct TriangleForms {
  std::array<RayPoint<Number>, 3> corners;
  std::array<Vector3<Number>, 3> sides;  ///< from each corner to the next
  PlaneForm<Number> plane;
};

template <class Number>
[[nodiscard]] TriangleForms<Number> triangle_forms(const std::array<RayPoint<Number>, 3>& corners) {
  const auto& [a, b, c] = corners;
  const std::array<Vector3<Number>, 3> sides{cross(a.ray, b.ray), cross(b.ray, c.ray), cross(c.ray, a.ray)};
  const Vector3<Number> of_ray = a.nearness * sides[1] + b.nearness * sides[2] + c.nearness * sides[0];
  return {corners, sides, {of_ray, dot(sides[0], c.ray)}};
}

template <class Units>
[[nodiscard]] auto triangle_forms(const Rays& rays, const Units& units, const std::array<Vec3, 3>& t) {
  using Number = typename Units::Number;
  return triangle_forms<Number>({rays.point(units, t[0]), rays.point(units, t[1]), rays.point(units, t[2])});
}

/// A form that is not negative where the plane of the triangle lies in the half-space.
template <class Number>
[[nodiscard]] Vector3<Number> side_of(const PlaneForm<Number>& plane, const RayForm<Number>& half_space) {
  return plane.unit * half_space.of_ray + half_space.of_nearness * plane.of_ray;
}

/// A form that is positive where the first plane is nearer.
template <class Number>
[[nodiscard]] Vector3<Number> nearer(const PlaneForm<Number>& first, const PlaneForm<Number>& second) {
  return second.unit * first.of_ray - first.unit * second.of_ray;
}

struct CoverTriangle {
  std::array<Vec3, 3> corners;  ///< counter-clockwise in the plane of rays
  TriangleForms<RunningError> forms;
  Vector3<RunningError> drawn;  ///< for a cover that is cut: not negative where the triangle is drawn
};

/// The rays between two points. A triangle seen edge-on is seen as the rays to its edges.
struct CoverArc {
  Vec3 from, to;
  bool is_at_viewpoint;  ///< of a triangle that holds the viewpoint, and so hides all of these rays
};

[[nodiscard]] inline double largest(const Vec3& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

/// The number of bits behind the binary point, or less than 0 for an even integer. Shifted by as many bits, the number is an
/// integer.
[[nodiscard]] inline int shift_for(double x) { return x == 0 ? 0 : -BinaryParts(x).lowest(); }
[[nodiscard]] inline int shift_for(const Vec3& v) { return std::max({shift_for(v.x), shift_for(v.y), shift_for(v.z)}); }

struct CoverParts {
  Rays rays;
  double factor = 1;  ///< the factor of RoundedUnits
  int shift = 0;      ///< the least shift of IntegerUnits
  std::optional<HalfSpace> drawn;
  std::vector<CoverTriangle> triangles;
  std::vector<CoverArc> arcs;
};

/// The same parts in units in which `extent` is about 1.
[[nodiscard]] CoverParts in_units_for(const CoverParts& parts, double extent);

}  // namespace occlude::kernel
