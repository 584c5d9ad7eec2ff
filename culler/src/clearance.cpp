// SPDX-License-Identifier: MIT
#include "occlude/culler/clearance.h"

#include <glm/geometric.hpp>
#include <limits>
#include <variant>

#include "bounds.h"

namespace occlude::culler {

Clearance clearance(const kernel::ShadowFrustum& shadow, const Box& box) {
  Clearance result{std::numeric_limits<double>::infinity(), 0};
  for (std::size_t i = 0; i < shadow.plane_count(); ++i) {
    const kernel::FilterPlane& plane = shadow.filter_planes()[i];
    const glm::dvec3 normal = to_glm(plane.normal);
    const double value = plane.offset + std::visit([&](const auto& b) { return least(normal, shadow.origin(), b); }, box);
    const double distance = value / glm::length(normal);
    if (distance < result.distance) result = {distance, i};
  }
  return result;
}

double distance_beyond(const HalfSpace& half_space, const Box& box) {
  const double greatest = -std::visit([&](const auto& b) { return least(-half_space.normal, {}, b); }, box);
  return -(greatest + half_space.offset) / glm::length(half_space.normal);
}

}  // namespace occlude::culler
