// SPDX-License-Identifier: MIT
#include "occlude/culler/shadow_margin.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "bounds.h"
#include "frame_view.h"
#include "occlude/kernel/overlap.h"
#include "outer_box.h"
#include "single_precision.h"

namespace occlude::culler {

ShadowMargin::ShadowMargin(const FrameView& view, double share)
    : eye_(view.camera.eye),
      forward_(view.axes.forward),
      is_perspective_(view.camera.projection == Projection::perspective),
      size_(share * (2 * view.half_height)),
      rounding_(share == 0 ? 0 : kSinglePrecision * view.depth) {}

double ShadowMargin::size(const kernel::ShadowFrustum& shadow) const {
  if (!is_perspective_) return size_ + rounding_;
  double nearest = std::numeric_limits<double>::infinity();
  for (const kernel::Vec3& v : shadow.silhouette()) nearest = std::min(nearest, glm::dot(to_glm(v) - eye_, forward_));
  return size_ + rounding_ / std::max(nearest, std::numeric_limits<double>::min());
}

kernel::HalfSpace ShadowMargin::moved(const kernel::HalfSpace& plane, double size) const {
  const glm::dvec3 normal = to_glm(plane.normal);
  const double margin = size * glm::length(normal - glm::dot(normal, forward_) * forward_);
  const double offset = plane.offset - 2 * rounding_ * glm::length(normal);
  if (!is_perspective_) return {plane.normal, offset - margin};
  return {to_kernel(normal - margin * forward_), offset};
}

template <class Visit>
bool ShadowMargin::all_moved_planes(const kernel::ShadowFrustum& shadow, const Visit& visit) const {
  if (is_none()) return true;
  const double size = this->size(shadow);
  for (std::size_t i = 0, count = shadow.plane_count(); i < count; ++i) {
    if (!visit(moved(shadow.rounded_plane(i), size))) return false;
  }
  return true;
}

void ShadowMargin::move_planes(const kernel::ShadowFrustum& shadow, std::vector<kernel::HalfSpace>& planes) const {
  planes.clear();
  static_cast<void>(all_moved_planes(shadow, [&](const kernel::HalfSpace& plane) {
    planes.push_back(plane);
    return true;
  }));
}

template <class AnyBox>
bool ShadowMargin::keeps_in(const kernel::ShadowFrustum& shadow, const AnyBox& box) const {
  if (shadow.is_none()) return false;
  const kernel::Vec3 origin = shadow.origin();
  return all_moved_planes(shadow, [&](const kernel::HalfSpace& plane) { return holds(plane, origin, box); });
}

bool ShadowMargin::keeps(const kernel::ShadowFrustum& shadow, const kernel::Aabb& box) const {
  return keeps_in(shadow, box);
}
bool ShadowMargin::keeps(const kernel::ShadowFrustum& shadow, const kernel::Obb& box) const { return keeps_in(shadow, box); }

bool ShadowMargin::keeps(const kernel::ShadowUnion& shadows, const Box& box) const {
  if (shadows.first.is_none() && shadows.second.is_none()) return false;
  if (is_none()) return true;
  const kernel::Aabb moved = grown(outer_box(box), std::max(size(shadows.first), size(shadows.second)));
  return kernel::overlap_certified(shadows, moved, kernel::NearBoundary::open).relation == kernel::Relation::inside;
}

kernel::Aabb ShadowMargin::grown(const kernel::Aabb& box, double size) const {
  const double farthest = is_perspective_ ? -least(-forward_, to_kernel(eye_), box) : 1;  // along the line of sight
  const double by = size * std::max(farthest, 0.0) + 2 * rounding_;
  kernel::Aabb result = box;
  for (int axis = 0; axis < 3; ++axis) {
    result.min[axis] -= by;
    result.max[axis] += by;
  }
  return result;
}

}  // namespace occlude::culler
