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

template <class AnyBox>
bool ShadowMargin::keeps_in(const kernel::ShadowFrustum& shadow, const AnyBox& box) const {
  if (is_none()) return true;
  return std::ranges::all_of(shadow.filter_planes().first(shadow.plane_count()), [&](const kernel::FilterPlane& plane) {
    const glm::dvec3 normal = to_glm(plane.normal);
    const double margin = size_ * glm::length(normal - glm::dot(normal, forward_) * forward_);
    return is_perspective_ ? least(normal - margin * forward_, shadow.origin(), box) + plane.offset >= 0
                           : least(normal, shadow.origin(), box) + plane.offset >= margin;
  });
}

bool ShadowMargin::keeps(const kernel::ShadowFrustum& shadow, const kernel::Aabb& box) const {
  return keeps_in(shadow, box);
}
bool ShadowMargin::keeps(const kernel::ShadowFrustum& shadow, const kernel::Obb& box) const { return keeps_in(shadow, box); }

bool ShadowMargin::keeps(const kernel::ShadowUnion& shadows, const Box& box) const {
  return is_none() || kernel::overlap_certified(shadows, grown(outer_box(box)), kernel::NearBoundary::open).relation ==
                          kernel::Relation::inside;
}

kernel::Aabb ShadowMargin::grown(const kernel::Aabb& box) const {
  const double farthest = is_perspective_ ? -least(-forward_, to_kernel(eye_), box) : 1;  // along the line of sight
  const double by = size_ * std::max(farthest, 0.0);
  kernel::Aabb result = box;
  for (int axis = 0; axis < 3; ++axis) {
    result.min[axis] -= by;
    result.max[axis] += by;
  }
  return result;
}

}  // namespace occlude::culler
