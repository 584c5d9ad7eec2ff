// SPDX-License-Identifier: MIT
#include "occlude/culler/clearance.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "bounds.h"

namespace occlude::culler {
namespace {

/// What a few more roundings, of lengths and quotients, can do to a distance is far less than this share of it.
constexpr double kRounding = 0x1p-40;

/// No coordinate of the box, relative to the origin, is larger; up to rounding.
double reach(const kernel::Vec3& origin, const kernel::Aabb& box) {
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    largest = std::max({largest, std::fabs(box.min[axis] - origin[axis]), std::fabs(box.max[axis] - origin[axis])});
  }
  return largest;
}

double reach(const kernel::Vec3& origin, const kernel::Obb& box) {
  double sum = reach(origin, kernel::Aabb{box.center, box.center});
  for (const kernel::Vec3& edge : box.half_edges) sum += reach({}, kernel::Aabb{edge, edge});
  return sum;
}

template <class AnyBox>
Clearance clearance_of(const kernel::ShadowFrustum& shadow, const AnyBox& box) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (shadow.is_none()) return {-kInfinity, 0};
  Clearance result{kInfinity, 0};
  for (std::size_t i = 0; i < shadow.plane_count(); ++i) {
    const kernel::FilterPlane& plane = shadow.filter_planes()[i];
    const glm::dvec3 normal = to_glm(plane.normal);
    const double distance = (plane.offset + least(normal, shadow.origin(), box)) / glm::length(normal);
    if (distance < result.distance) result = {distance, i};
  }
  return result;
}

/// The least of value^2 / |normal|^2 over the planes, each rounded down. The kernel bounds what its values, computed as
/// here, are out by, and by the slope of that bound what a normal n is: its square is below (|n| + 2 slope)^2, and that by
/// the inequality of the means below (1 + t) |n|^2 + (1 + 1/t) (2 slope)^2, t the share that is given away.
template <class AnyBox>
double certain(const kernel::ShadowFrustum& shadow, const AnyBox& box) {
  if (shadow.is_none()) return 0;
  constexpr double kGiven = 0x1p-20;
  const kernel::FilterBound& bound = shadow.filter_bound();
  const double error = 2 * (bound.slope * reach(shadow.origin(), box) + bound.base);  // twice, for its second order
  const double uncertain = (1 + 1 / kGiven) * 4 * bound.slope * bound.slope;
  double value = std::numeric_limits<double>::infinity(), square = 1;  // of the nearest plane
  for (const kernel::FilterPlane& plane : shadow.filter_planes().first(shadow.plane_count())) {
    const glm::dvec3 normal = to_glm(plane.normal);
    const double own = plane.offset + least(normal, shadow.origin(), box) - error;
    if (!(own > 0)) return 0;
    const double own_square = (1 + kGiven) * glm::dot(normal, normal) + uncertain;
    if (own * own * square >= value * value * own_square) continue;
    value = own;
    square = own_square;
  }
  return value / std::sqrt(square) * (1 - kRounding);
}

template <class AnyBox>
double beyond(const HalfSpace& half_space, const AnyBox& box) {
  const double greatest = -least(-half_space.normal, {}, box) + half_space.offset;
  const double size = std::fabs(half_space.normal.x) + std::fabs(half_space.normal.y) + std::fabs(half_space.normal.z);
  // A sum of a few products, each with less than eight roundings.
  const double error = 0x1p-48 * (size * reach({}, box) + std::fabs(half_space.offset));
  const double distance = -(greatest + error) / glm::length(half_space.normal);
  return distance * (distance > 0 ? 1 - kRounding : 1 + kRounding);
}

}  // namespace

Clearance clearance(const kernel::ShadowFrustum& shadow, const kernel::Aabb& box) { return clearance_of(shadow, box); }
Clearance clearance(const kernel::ShadowFrustum& shadow, const kernel::Obb& box) { return clearance_of(shadow, box); }

double certain_distance(const kernel::ShadowFrustum& shadow, const kernel::Aabb& box) { return certain(shadow, box); }
double certain_distance(const kernel::ShadowFrustum& shadow, const kernel::Obb& box) { return certain(shadow, box); }

double distance_beyond(const HalfSpace& half_space, const kernel::Aabb& box) { return beyond(half_space, box); }
double distance_beyond(const HalfSpace& half_space, const kernel::Obb& box) { return beyond(half_space, box); }

}  // namespace occlude::culler
