// SPDX-License-Identifier: MIT
#include "occlude/culler/clearance.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "bounds.h"

namespace occlude::culler {
namespace {

/// What a few more roundings, of lengths and quotients, can do to a distance is far less than this share of it.
constexpr double kRounding = 0x1p-40;

/// No coordinate of the box is larger; up to rounding.
double reach(const kernel::Vec3& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }
double reach(const kernel::Aabb& box) { return std::max(reach(box.min), reach(box.max)); }
double reach(const kernel::Obb& box) {
  double sum = reach(box.center);
  for (const kernel::Vec3& edge : box.half_edges) sum += reach(edge);
  return sum;
}

template <class AnyBox>
double beyond(const HalfSpace& half_space, const AnyBox& box) {
  const double greatest = -least(-half_space.normal, {}, box) + half_space.offset;
  const double size = std::fabs(half_space.normal.x) + std::fabs(half_space.normal.y) + std::fabs(half_space.normal.z);
  // A sum of a few products, each with less than eight roundings.
  const double error = 0x1p-48 * (size * reach(box) + std::fabs(half_space.offset));
  const double distance = -(greatest + error) / glm::length(half_space.normal);
  return distance * (distance > 0 ? 1 - kRounding : 1 + kRounding);
}

}  // namespace

double distance_beyond(const HalfSpace& half_space, const kernel::Aabb& box) { return beyond(half_space, box); }
double distance_beyond(const HalfSpace& half_space, const kernel::Obb& box) { return beyond(half_space, box); }

}  // namespace occlude::culler
