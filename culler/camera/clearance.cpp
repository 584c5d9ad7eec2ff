// SPDX-License-Identifier: MIT
#include "camera/clearance.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/bounds.h"

namespace occlude::culler {
namespace {

/// A distance takes a few more roundings, of lengths and quotients. Together they are far less than this share of it.
constexpr double kRounding = 0x1p-40;

/// Bounds the magnitude of the coordinates of the box, up to rounding.
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
  // The sum has a few products, each with fewer than eight roundings of 2^-53.
  const double error = 0x1p-48 * (size * reach(box) + std::fabs(half_space.offset));
  const double distance = -(greatest + error) / glm::length(half_space.normal);
  return distance * (distance > 0 ? 1 - kRounding : 1 + kRounding);
}

}  // namespace

double distance_beyond(const HalfSpace& half_space, const kernel::Aabb& box) { return beyond(half_space, box); }
double distance_beyond(const HalfSpace& half_space, const kernel::Obb& box) { return beyond(half_space, box); }

}  // namespace occlude::culler
