// SPDX-License-Identifier: MIT
#include "occlude/kernel/region_shadow.h"

#include <algorithm>

#include "box_plane.h"
#include "build_frustum.h"
#include "moderate.h"
#include "near_plane.h"
#include "paper/plain_overlap.h"
#include "polytope_cap.h"
#include "region_planes.h"
#include "separation.h"
#include "silhouette.h"
#include "stored_region_shadow.h"

namespace occlude::kernel {
namespace {

Refusal check(const ViewRegion& region) {
  if (const Refusal refusal = check(region.box); refusal != Refusal::none) return refusal;
  const bool is_zero = region.box == Obb{};
  return region.kind == Viewpoint::Kind::direction && is_zero ? Refusal::zero_direction : Refusal::none;
}

/// There are as many outlines as pairs of planes, and making the extents takes all of three. Beyond this many planes it
/// takes longer than many tests would gain: a box is cut by few of the planes, which the test then asks alone.
constexpr std::size_t kMostOutlined = 16;

/// Whether two or three planes together separate their intersection from the box, exactly. REQUIRES: it is not empty.
template <class Box>
bool is_separated_exactly(const StoredFrustum& planes, bool are_moderate, const Box& box) {
  if (!are_moderate || !is_moderate(box)) {
    BigArithmetic big;
    return Separation(big, planes, box).exists();
  }
  ExactArithmetic exact;
  return Separation(exact, planes, box).exists();
}

/// The same, by the filter where its bounds suffice.
template <class Box>
bool is_separated(const StoredFrustum& planes, bool are_moderate, const Box& box, Stage& stage) {
  if (are_moderate && is_moderate(box)) {
    FilterArithmetic filter;
    if (Separation(filter, planes, box).exists()) return true;
    if (!filter.failed()) return false;
  }
  stage = Stage::exact;
  return is_separated_exactly(planes, are_moderate, box);
}

bool is_separated(const StoredRegionShadow& shadow, const Obb& box, Stage& stage) {
  return is_separated(shadow.planes, shadow.is_moderate, box, stage);
}

/// By the outlines and extents that are stored, where these suffice.
bool is_separated(const StoredRegionShadow& shadow, const Aabb& box, Stage& stage) {
  if (!shadow.has_outlines) return is_separated(shadow.planes, shadow.is_moderate, box, stage);
  bool is_known = true;
  for (int axis = 0; axis < 3; ++axis) {
    const auto& [least, greatest] = shadow.extents[static_cast<std::size_t>(axis)];
    if (box.max[axis] < least.low || box.min[axis] > greatest.high) return true;
    is_known = is_known && box.max[axis] >= least.high && box.min[axis] <= greatest.low;
  }
  const auto frame = frame_of<PlainArithmetic>(box, shadow.planes.origin);
  const double error = frame.error(shadow.outline_bound);
  for (const FilterPlane& plane : shadow.outlines) {
    const double high = frame.extremes(plane).high();
    if (high < -error) return true;
    is_known = is_known && high > error;
  }
  if (is_known) return false;
  stage = Stage::exact;
  return is_separated_exactly(shadow.planes, true, box);
}

template <class Box>
Decision conservative(const RegionShadow& shadow, const Box& box, NearBoundary near) {
  const StoredFrustum& planes = shadow.stored().planes;
  return box_planes_certified(planes, box, frame_of<PlainArithmetic>(box, planes.origin), near);
}

template <class Box>
Decision overlap(const RegionShadow& shadow, const Box& box, NearBoundary near) {
  Decision decision = conservative(shadow, box, near);
  if (decision.relation == Relation::partial && is_separated(shadow.stored(), box, decision.stage)) {
    decision.relation = Relation::outside;
  }
  return decision;
}

template <class Box>
Relation plain(const RegionShadow& shadow, const Box& box, NearBoundary near) {
  const StoredFrustum& planes = shadow.stored().planes;
  const Relation by_planes = box_planes_plain(planes, plain_frame_of<PlainArithmetic>(box, planes.origin), near);
  PlainArithmetic arithmetic;
  const bool is_outside = by_planes == Relation::partial && Separation(arithmetic, planes, box).exists();
  return is_outside ? Relation::outside : by_planes;
}

/// REQUIRES: the region does not meet the occluder, nor the plane of a polygon.
std::shared_ptr<const StoredRegionShadow> shadow_of(const OccluderSurface& occluder, const ViewRegion& region,
                                                    ShadowKind kind, Scratch& scratch) {
  StoredRegionShadow shadow;
  StoredFrustum& planes = shadow.planes;
  const RegionPlanes made = region_planes(occluder, region, kind, scratch.memory());
  planes.origin = occluder.vertices[0];
  planes.recipes.assign(made.near.begin(), made.near.end());
  planes.recipes.insert(planes.recipes.end(), made.sides.begin(), made.sides.end());
  planes.near_count = made.near.size();
  planes.plane_count = planes.recipes.size();
  round_planes(planes, planes.filter_bound);
  shadow.is_moderate = is_moderate(region.box) && is_moderate(occluder.vertices);
  shadow.has_outlines = shadow.is_moderate && planes.plane_count <= kMostOutlined;
  if (shadow.has_outlines) add_outlines(shadow);
  return std::make_shared<const StoredRegionShadow>(std::move(shadow));
}

/// The corners of a loop in its own plane, which is seen along a coordinate axis that is not in it.
Silhouette corners_in_plane(std::span<const Vec3> loop, Scratch& scratch) {
  Silhouette corners;
  for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    corners = silhouette(Viewpoint::direction(axis), loop, scratch.memory());
    if (corners.refusal != Refusal::eye_in_plane) break;
  }
  return corners;
}

ExactPlane turned(ExactPlane plane) {
  std::swap(plane.a_to, plane.b_to);
  std::swap(plane.a_from, plane.b_from);
  return plane;
}

/// The faces of a polytope as planes of a frustum.
StoredFrustum planes_of(const OccluderSurface& occluder) {
  StoredFrustum planes;
  if (occluder.faces.empty()) return planes;
  planes.origin = occluder.vertices[0];
  planes.recipes.assign(occluder.faces.begin(), occluder.faces.end());
  planes.plane_count = planes.recipes.size();
  return planes;
}

/// The planes whose only common point is 0.
StoredFrustum planes_at_zero() {
  StoredFrustum planes;
  for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    planes.recipes.emplace_back(
        ExactPlane{.direct = true, .a_to = axis, .a_from = {}, .b_to = {}, .b_from = {}, .origin = {}});
    planes.recipes.emplace_back(
        ExactPlane{.direct = true, .a_to = {}, .a_from = axis, .b_to = {}, .b_from = {}, .origin = {}});
  }
  planes.plane_count = planes.recipes.size();
  return planes;
}

/// Whether the box meets the intersection of the planes, exactly. REQUIRES: that is not empty.
bool meets(StoredFrustum planes, bool are_moderate, const Obb& box) {
  round_planes(planes, planes.filter_bound);
  const auto frame = frame_of<PlainArithmetic>(box, planes.origin);
  Decision decision = box_planes_certified(planes, box, frame, NearBoundary::closed);
  return decision.relation != Relation::outside && !is_separated(planes, are_moderate, box, decision.stage);
}

}  // namespace

std::size_t RegionShadow::plane_count() const { return stored_->planes.plane_count; }
std::size_t RegionShadow::near_count() const { return stored_->planes.near_count; }

RegionShadowResult RegionShadow::make(const ViewRegion& region, std::span<const Vec3> loop, ShadowKind kind) {
  if (const Refusal refusal = check_rounding(); refusal != Refusal::none) return {std::nullopt, refusal};
  if (const Refusal refusal = check(loop); refusal != Refusal::none) return {std::nullopt, refusal};
  if (const Refusal refusal = check(region); refusal != Refusal::none) return {std::nullopt, refusal};
  Scratch scratch;
  auto [corners, refusal] = corners_in_plane(loop, scratch);
  if (refusal != Refusal::none) return {std::nullopt, refusal};
  std::optional<ExactPlane> plane = polygon_plane(corners, loop);
  if (!plane) return {std::nullopt, Refusal::not_coplanar};
  const auto eyes = corners_of(region, scratch.memory());
  const auto are_all = [&](int sign) {
    return std::ranges::all_of(eyes, [&](const RegionCorner& eye) { return sign_at(*plane, eye) == sign; });
  };
  const bool is_seen_from_beyond = are_all(1);
  if (!is_seen_from_beyond && !are_all(-1)) return {std::nullopt, Refusal::eye_in_plane};
  if (is_seen_from_beyond) {
    std::ranges::reverse(corners);
    plane = turned(*plane);
  }
  OccluderSurface surface(scratch.memory());
  surface.faces = {*plane, turned(*plane)};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    surface.edges.push_back({corners[(i + 1) % corners.size()], corners[i], 0, 1});  // clockwise seen from the eyes
  }
  surface.vertices = std::move(corners);
  return {RegionShadow(shadow_of(surface, region, kind, scratch)), Refusal::none};
}

RegionShadowResult RegionShadow::make(const ViewRegion& region, const ConvexPolytope& polytope, ShadowKind kind) {
  if (const Refusal refusal = check_rounding(); refusal != Refusal::none) return {std::nullopt, refusal};
  if (const Refusal refusal = check(region); refusal != Refusal::none) return {std::nullopt, refusal};
  Scratch scratch;
  OccluderSurface surface(scratch.memory());
  const auto vertices = polytope.vertices();
  surface.vertices.assign(vertices.begin(), vertices.end());
  for (std::uint32_t face = 0; face < polytope.faces().size(); ++face) surface.faces.push_back(inner_plane(polytope, face));
  for (const auto& [from, to, left, right] : polytope.edges()) {
    surface.edges.push_back({vertices[from], vertices[to], left, right});
  }
  if (region.kind == Viewpoint::Kind::direction && meets(planes_at_zero(), true, region.box)) {
    return {std::nullopt, Refusal::zero_direction};
  }
  const bool has_eye_within =
      region.kind == Viewpoint::Kind::eye && meets(planes_of(surface), is_moderate(surface.vertices), region.box);
  if (has_eye_within || surface.faces.empty()) return {std::nullopt, Refusal::eye_in_polytope};
  return {RegionShadow(shadow_of(surface, region, kind, scratch)), Refusal::none};
}

Decision overlap_certified(const RegionShadow& shadow, const Aabb& box, NearBoundary near) {
  return overlap(shadow, box, near);
}
Decision overlap_certified(const RegionShadow& shadow, const Obb& box, NearBoundary near) {
  return overlap(shadow, box, near);
}
Decision conservative_certified(const RegionShadow& shadow, const Aabb& box, NearBoundary near) {
  return conservative(shadow, box, near);
}
Decision conservative_certified(const RegionShadow& shadow, const Obb& box, NearBoundary near) {
  return conservative(shadow, box, near);
}
Relation overlap_plain(const RegionShadow& shadow, const Aabb& box, NearBoundary near) { return plain(shadow, box, near); }
Relation overlap_plain(const RegionShadow& shadow, const Obb& box, NearBoundary near) { return plain(shadow, box, near); }

}  // namespace occlude::kernel
