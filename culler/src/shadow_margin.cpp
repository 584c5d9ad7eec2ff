// SPDX-License-Identifier: MIT
#include "occlude/culler/shadow_margin.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "bounds.h"
#include "occlude/kernel/overlap.h"
#include "outer_box.h"

namespace occlude::culler {

ShadowMargin::ShadowMargin(const Camera& camera, double share)
    : eye_(camera.eye),
      forward_(camera.axes().forward),
      is_perspective_(camera.projection == Projection::perspective),
      size_(share * (is_perspective_ ? 2 * std::tan(glm::radians(camera.fov_y_deg) / 2) : camera.height)) {}

/// `least` gives the least of n . (x - origin) over the box.
template <class Least>
bool ShadowMargin::keeps_planes(const kernel::ShadowFrustum& shadow, Least&& least) const {
  return std::ranges::all_of(shadow.filter_planes().first(shadow.plane_count()), [&](const kernel::FilterPlane& plane) {
    const glm::dvec3 normal = to_glm(plane.normal);
    const double margin = size_ * glm::length(normal - glm::dot(normal, forward_) * forward_);
    return is_perspective_ ? least(normal - margin * forward_) + plane.offset >= 0 : least(normal) + plane.offset >= margin;
  });
}

bool ShadowMargin::keeps(const kernel::ShadowFrustum& shadow, const kernel::Aabb& box) const {
  if (is_none()) return true;
  const kernel::Vec3& origin = shadow.origin();
  return keeps_planes(shadow, [&](const glm::dvec3& n) {
    double least = 0;
    for (int axis = 0; axis < 3; ++axis) least += n[axis] * ((n[axis] > 0 ? box.min : box.max)[axis] - origin[axis]);
    return least;
  });
}

bool ShadowMargin::keeps(const kernel::ShadowFrustum& shadow, const kernel::Obb& box) const {
  if (is_none()) return true;
  const glm::dvec3 centre = to_glm(box.center) - to_glm(shadow.origin());
  return keeps_planes(shadow, [&](const glm::dvec3& n) {
    double least = glm::dot(n, centre);
    for (const kernel::Vec3& edge : box.half_edges) least -= std::fabs(glm::dot(n, to_glm(edge)));
    return least;
  });
}

bool ShadowMargin::keeps(const kernel::ShadowUnion& shadows, const Box& box) const {
  return is_none() || kernel::overlap_certified(shadows, grown(outer_box(box)), kernel::NearBoundary::open).relation ==
                          kernel::Relation::inside;
}

kernel::Aabb ShadowMargin::grown(const kernel::Aabb& box) const {
  double farthest = 1;  // of the box along the line of sight
  if (is_perspective_) {
    farthest = 0;
    for (int axis = 0; axis < 3; ++axis) {
      farthest += forward_[axis] * ((forward_[axis] > 0 ? box.max : box.min)[axis] - eye_[axis]);
    }
  }
  const double by = size_ * std::max(farthest, 0.0);
  kernel::Aabb result = box;
  for (int axis = 0; axis < 3; ++axis) {
    result.min[axis] -= by;
    result.max[axis] += by;
  }
  return result;
}

}  // namespace occlude::culler
