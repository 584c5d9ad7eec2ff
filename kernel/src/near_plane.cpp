// SPDX-License-Identifier: MIT
#include "near_plane.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "plane_coefficients.h"

namespace occlude::kernel {
namespace {

/// Positive where `a` is farther than `b`: the sign of |a - V|^2 - |b - V|^2, or of d . (a - b).
int compare_distance(const Viewpoint& viewpoint, const Vec3& a, const Vec3& b) {
  return certified([&]<class A>(A& arithmetic) {
    if (!viewpoint.is_eye()) return arithmetic.sign(dot(difference<A>(viewpoint.value, {}), difference<A>(a, b)));
    const auto to_a = difference<A>(a, viewpoint.value), to_b = difference<A>(b, viewpoint.value);
    return arithmetic.sign(dot(to_a, to_a) - dot(to_b, to_b));
  });
}

/// Scales by a power of two to a largest component in [1/2, 1) and drops components below 2^-60: the result is within the
/// legal range whatever the scale of the model. Zero stays zero. Dropping them is allowed because a support plane is sound
/// with any normal.
Vec3 normalised(const Vector3<double>& v) {
  int exponent = 0;
  std::frexp(std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}), &exponent);
  const auto component = [&](double x) {
    const double scaled = std::ldexp(x, -exponent);
    return std::fabs(scaled) < 0x1p-60 ? 0 : scaled;
  };
  return {component(v.x), component(v.y), component(v.z)};
}

/// Newell's normal of the loop, which is the sum of the normals of its fan: the normal of a mean plane.
Vec3 mean_normal(std::span<const Vec3> corners) {
  Vector3<double> sum{0, 0, 0};
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum = sum + cross(difference<PlainArithmetic>(corners[i], corners[0]),
                      difference<PlainArithmetic>(corners[i + 1], corners[0]));
  }
  return normalised(sum);
}

/// The vertex at which the exact value of normal . v is largest.
Vec3 extreme_vertex(const Vec3& normal, std::span<const Vec3> loop) {
  Vec3 best = loop[0];
  for (const Vec3& v : loop) {
    if (sign_at(exact_plane({normal, best}), v) > 0) best = v;
  }
  return best;
}

/// Whether the viewpoint is strictly before the plane, so that the plane really lies behind the polygon.
bool is_before(const Viewpoint& viewpoint, const SupportPlane& plane) {
  if (viewpoint.is_eye()) return sign_at(exact_plane(plane), viewpoint.value) < 0;
  return sign_at(exact_plane({plane.normal, {}}), viewpoint.value) > 0;
}

/// The direction of sight to the farthest vertex. It serves the rare loop whose mean plane does not have the viewpoint
/// strictly before it.
Vec3 sight_normal(const Viewpoint& viewpoint, std::span<const Vec3> loop) {
  return normalised(normal<PlainArithmetic>(farthest_plane(viewpoint, loop)));
}

}  // namespace

ExactPlane farthest_plane(const Viewpoint& viewpoint, std::span<const Vec3> loop) {
  Vec3 farthest = loop[0];
  for (const Vec3& v : loop) {
    if (v != farthest && compare_distance(viewpoint, v, farthest) > 0) farthest = v;
  }
  return viewpoint.is_eye()
             ? ExactPlane{.direct = true,
                          .a_to = farthest,
                          .a_from = viewpoint.value,
                          .b_to = {},
                          .b_from = {},
                          .origin = farthest}
             : ExactPlane{
                   .direct = true, .a_to = viewpoint.value, .a_from = {}, .b_to = {}, .b_from = {}, .origin = farthest};
}

std::optional<ExactPlane> polygon_plane(std::span<const Vec3> corners, std::span<const Vec3> loop) {
  const ExactPlane plane{.direct = false,
                         .a_to = corners[1],
                         .a_from = corners[0],
                         .b_to = corners[2],
                         .b_from = corners[0],
                         .origin = corners[0]};
  const bool coplanar = std::all_of(loop.begin(), loop.end(), [&](const Vec3& v) { return sign_at(plane, v) == 0; });
  return coplanar ? std::optional(plane) : std::nullopt;
}

SupportPlane support_plane(const Viewpoint& viewpoint, std::span<const Vec3> corners, std::span<const Vec3> loop) {
  const Vec3 mean = mean_normal(corners);
  const SupportPlane plane{mean, extreme_vertex(mean, loop)};
  if (is_before(viewpoint, plane)) return plane;
  const Vec3 sight = sight_normal(viewpoint, loop);
  return {sight, extreme_vertex(sight, loop)};
}

ExactPlane exact_plane(const SupportPlane& plane) {
  return {.direct = true, .a_to = plane.normal, .a_from = {}, .b_to = {}, .b_from = {}, .origin = plane.point};
}

}  // namespace occlude::kernel
