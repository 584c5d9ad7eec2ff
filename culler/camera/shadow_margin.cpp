// SPDX-License-Identifier: MIT
#include "camera/shadow_margin.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "camera/eye_region.h"
#include "camera/frame_view.h"
#include "camera/single_precision.h"
#include "model/bounds.h"
#include "model/outer_box.h"
#include "occlude/kernel/overlap.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {

ShadowMargin::ShadowMargin(const FrameView& view, double share)
    : eye_(view.eye),
      forward_(view.axes.forward),
      is_perspective_(view.is_perspective),
      size_(share * view.height),
      rounding_(share == 0 ? 0 : kSinglePrecision * view.depth),
      eye_error_(view.eye_uncertainty + radius_of(view.eyes)) {}

/// A vertex w along the line of sight and a across it moves by d and e. In the picture that is from a / w to
/// (a + e) / (w + d): by (w e - a d) / (w (w + d)), which is no longer than |(d, e)| |(w, a)| / (w (w - |d|)).
double ShadowMargin::size(const kernel::ShadowFrustum& shadow) const {
  if (!is_perspective_ || rounding_ == 0) return size_ + rounding_;
  double most = 0;
  for (const kernel::Vec3& vertex : shadow.silhouette()) {
    const glm::dvec3 v = to_glm(vertex) - eye_;
    const double along = glm::dot(v, forward_);
    if (!(along > rounding_)) return std::numeric_limits<double>::infinity();
    most = std::max(most, glm::length(v) / (along * (along - rounding_)));
  }
  return size_ + rounding_ * most;
}

kernel::HalfSpace ShadowMargin::moved(const kernel::HalfSpace& plane, double size) const {
  const glm::dvec3 normal = to_glm(plane.normal);
  const double margin = size * glm::length(normal - glm::dot(normal, forward_) * forward_);
  const glm::dvec3 turned = is_perspective_ ? normal - margin * forward_ : normal;
  const double offset = plane.offset - rounding_ * (glm::length(normal) + glm::length(turned));
  return {to_kernel(turned), is_perspective_ ? offset : offset - margin};
}

template <class Visit>
bool ShadowMargin::all_moved_planes(const kernel::ShadowFrustum& shadow, const Visit& visit) const {
  if (size_ == 0) return true;
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
  return all_moved_planes(shadow, [&](const kernel::HalfSpace& plane) { return holds(plane, origin, box); }) &&
         (eye_error_ == 0 || holds_from_all_eyes(shadow, outer_box(box)));
}

bool ShadowMargin::keeps(const kernel::ShadowFrustum& shadow, const kernel::Aabb& box) const {
  return keeps_in(shadow, box);
}
bool ShadowMargin::keeps(const kernel::ShadowFrustum& shadow, const kernel::Obb& box) const { return keeps_in(shadow, box); }

bool ShadowMargin::keeps(const kernel::ShadowUnion& shadows, const Box& box) const {
  if (shadows.first.is_none() && shadows.second.is_none()) return false;
  if (eye_error_ != 0) return false;
  if (size_ == 0) return true;
  const kernel::Aabb moved = grown(outer_box(box), std::max(size(shadows.first), size(shadows.second)));
  return kernel::check(moved) == kernel::Refusal::none &&
         kernel::overlap_certified(shadows, moved, kernel::NearBoundary::open).relation == kernel::Relation::inside;
}

namespace {

kernel::Aabb grown_by(kernel::Aabb box, double length) {
  for (int axis = 0; axis < 3; ++axis) {
    box.min[axis] -= length;
    box.max[axis] += length;
  }
  return box;
}

/// Bounds the rounding of a dot product with a unit vector, of a point that far from the eye in the sum of the axes.
double rounding_of(double reach) { return 0x1p-50 * reach; }

}  // namespace

kernel::Aabb ShadowMargin::grown(const kernel::Aabb& box, double size) const {
  const double farthest = is_perspective_ ? -least(-forward_, to_kernel(eye_), box) : 1;  // along the line of sight
  return grown_by(box, size * std::max(farthest, 0.0) + 2 * rounding_);
}

bool ShadowMargin::holds_from_all_eyes(const kernel::ShadowFrustum& shadow, const kernel::Aabb& box) const {
  const auto reach_of = [&](const kernel::Aabb& b) { return depth(b, eye_); };
  double moves = 2;
  if (is_perspective_) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const kernel::Vec3& v : shadow.silhouette()) {
      const double along = glm::dot(to_glm(v) - eye_, forward_);
      nearest = std::min(nearest, along - rounding_of(reach_of({v, v})) - eye_error_);
    }
    if (!(nearest > 0)) return false;
    moves = (-least(-forward_, to_kernel(eye_), box) + rounding_of(reach_of(box)) + eye_error_) / nearest;
  }
  // The factor, and the rounding of coordinates, are more than what this takes.
  const double most = depth(box, {0, 0, 0});
  const kernel::Aabb moved = grown_by(box, (1 + 0x1p-40) * eye_error_ * std::max(moves, 0.0) + 0x1p-50 * most);
  return kernel::check(moved) == kernel::Refusal::none &&
         kernel::overlap_certified(shadow, moved, kernel::NearBoundary::open).relation == kernel::Relation::inside;
}

}  // namespace occlude::culler
