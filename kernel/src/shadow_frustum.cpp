// SPDX-License-Identifier: MIT
#include "occlude/kernel/shadow_frustum.h"

#include <cmath>

#include "error_bounds.h"
#include "near_plane.h"
#include "plane_value.h"
#include "silhouette.h"

namespace occlude::kernel {
namespace {

Refusal check_input(const Viewpoint& viewpoint, std::span<const Vec3> loop) {
  if (const Refusal refusal = check(viewpoint.value); refusal != Refusal::none) return refusal;
  for (const Vec3& v : loop) {
    if (const Refusal refusal = check(v); refusal != Refusal::none) return refusal;
  }
  if (!viewpoint.is_eye() && viewpoint.value == Vec3{}) return Refusal::zero_direction;
  return Refusal::none;
}

/// Rounds a plane and bounds what rounding does to its values (kPlaneError).
FilterPlane filter_plane(const ExactPlane& plane) {
  const auto n = normal<PlainArithmetic>(plane);
  const auto a = difference<PlainArithmetic>(plane.a_to, plane.a_from);
  double magnitudes = std::fabs(a.x) + std::fabs(a.y) + std::fabs(a.z);
  if (!plane.direct) {
    const auto b = difference<PlainArithmetic>(plane.b_to, plane.b_from);
    magnitudes = (std::fabs(a.y * b.z) + std::fabs(a.z * b.y)) + (std::fabs(a.z * b.x) + std::fabs(a.x * b.z)) +
                 (std::fabs(a.x * b.y) + std::fabs(a.y * b.x));
  }
  return {.normal = {n.x, n.y, n.z}, .origin = plane.origin, .bound = kPlaneError * magnitudes};
}

}  // namespace

ShadowFrustumResult ShadowFrustum::make(const Viewpoint& viewpoint, std::span<const Vec3> loop, Near near) {
  if (const Refusal refusal = check_input(viewpoint, loop); refusal != Refusal::none) return {std::nullopt, refusal};
  Silhouette outline = kernel::silhouette(viewpoint, loop);
  if (outline.refusal != Refusal::none) return {std::nullopt, outline.refusal};

  ShadowFrustum frustum;
  frustum.viewpoint_ = viewpoint;
  frustum.silhouette_ = std::move(outline.corners);
  const std::vector<Vec3>& corners = frustum.silhouette_;

  std::vector<ExactPlane>& planes = frustum.exact_planes_;
  planes.reserve(corners.size() + 1);
  if (near == Near::farthest) {
    planes.push_back(farthest_plane(viewpoint, loop));
  } else if (const auto own = polygon_plane(corners, loop)) {
    planes.push_back(*own);
    frustum.near_is_polygon_ = true;
  } else {
    frustum.support_plane_ = kernel::support_plane(viewpoint, corners, loop);
    planes.push_back(exact_plane(*frustum.support_plane_));
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    planes.push_back(side_plane(viewpoint, corners[i], corners[(i + 1) % corners.size()]));
  }
  frustum.filter_planes_.reserve(planes.size());
  for (const ExactPlane& plane : planes) frustum.filter_planes_.push_back(filter_plane(plane));
  return {std::move(frustum), Refusal::none};
}

}  // namespace occlude::kernel
