// SPDX-License-Identifier: MIT
#include "occlude/kernel/clearance.h"

#include <cmath>
#include <limits>

#include "arithmetic.h"
#include "box_frame.h"
#include "stored_frustum.h"

namespace occlude::kernel {
namespace {

using Vector = Vector3<double>;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Vector vector(const Vec3& v) { return constants<PlainArithmetic>(v); }

/// The least value of the plane over the box, up to rounding.
double least(const FilterPlane& plane, const Vec3& origin, const Aabb& box) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    sum += plane.normal[axis] * ((plane.normal[axis] > 0 ? box.min : box.max)[axis] - origin[axis]);
  }
  return plane.offset + sum;
}

double least(const FilterPlane& plane, const Vec3& origin, const Obb& box) {
  const Vector normal = vector(plane.normal);
  double sum = dot(normal, difference<PlainArithmetic>(box.center, origin));
  for (const Vec3& edge : box.half_edges) sum -= std::fabs(dot(normal, vector(edge)));
  return plane.offset + sum;
}

double squared_length(const FilterPlane& plane) { return dot(vector(plane.normal), vector(plane.normal)); }

template <class AnyBox>
Clearance clearance_of(const ShadowFrustum& shadow, const AnyBox& box) {
  const StoredFrustum* const frustum = stored(shadow);
  if (!frustum) return {-kInfinity, 0};
  Clearance result{kInfinity, 0};
  for (std::size_t i = 0; i < frustum->plane_count; ++i) {
    const FilterPlane& plane = frustum->filter_planes[i];
    const double distance = least(plane, frustum->origin, box) / std::sqrt(squared_length(plane));
    if (distance < result.distance) result = {distance, i};
  }
  return result;
}

/// A lower bound on the distance to the nearest plane: finds the least value^2 / |normal|^2 over the planes, each rounded
/// down. A value computed as here is off by at most the filter's bound, and a normal n by at most the slope of that bound.
/// The square of the true normal is below (|n| + 2 slope)^2. By the inequality of the means this is below (1 + t) |n|^2 + (1
/// + 1/t) (2 slope)^2, where t is the share that is given away.
template <class AnyBox>
double certain(const ShadowFrustum& shadow, const AnyBox& box) {
  const StoredFrustum* const frustum = stored(shadow);
  if (!frustum) return 0;
  constexpr double kGiven = 0x1p-20;
  // The few remaining roundings, of lengths and quotients, change a distance by far less than this share of it.
  constexpr double kRounding = 0x1p-40;
  const FilterBound& bound = frustum->filter_bound;
  const double reach = frame_of<PlainArithmetic>(box, frustum->origin).reach();
  const double error = 2 * (bound.slope * reach + bound.base);  // twice, for its second order
  const double uncertain = (1 + 1 / kGiven) * 4 * bound.slope * bound.slope;
  double value = kInfinity, square = 1;  // of the nearest plane
  for (const FilterPlane& plane : frustum->own_planes()) {
    const double own = least(plane, frustum->origin, box) - error;
    if (!(own > 0)) return 0;
    const double own_square = (1 + kGiven) * squared_length(plane) + uncertain;
    if (own * own * square >= value * value * own_square) continue;
    value = own;
    square = own_square;
  }
  return value / std::sqrt(square) * (1 - kRounding);
}

}  // namespace

Clearance clearance(const ShadowFrustum& shadow, const Aabb& box) { return clearance_of(shadow, box); }
Clearance clearance(const ShadowFrustum& shadow, const Obb& box) { return clearance_of(shadow, box); }

double certain_distance(const ShadowFrustum& shadow, const Aabb& box) { return certain(shadow, box); }
double certain_distance(const ShadowFrustum& shadow, const Obb& box) { return certain(shadow, box); }

}  // namespace occlude::kernel
