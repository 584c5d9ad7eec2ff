// SPDX-License-Identifier: MIT
// Translates the kernel's types into the oracle's. The two share none.
#pragma once

#include <vector>

#include "cases/case.h"
#include "occlude/kernel/shadow_frustum.h"
#include "occlude/oracle/oracle.h"
#include "occlude/oracle/region_shadow.h"

namespace occlude::cases {

[[nodiscard]] inline oracle::Point to_oracle(const kernel::Vec3& v) { return {v.x, v.y, v.z}; }
[[nodiscard]] inline oracle::Viewpoint to_oracle(const kernel::Viewpoint& v) { return {to_oracle(v.value), !v.is_eye()}; }
[[nodiscard]] inline oracle::Aabb to_oracle(const kernel::Aabb& box) { return {to_oracle(box.min), to_oracle(box.max)}; }

[[nodiscard]] inline oracle::Obb to_oracle(const kernel::Obb& box) {
  return {to_oracle(box.center), {to_oracle(box.half_edges[0]), to_oracle(box.half_edges[1]), to_oracle(box.half_edges[2])}};
}

[[nodiscard]] inline oracle::Box to_oracle(const Box& box) {
  return std::visit([](const auto& kind) -> oracle::Box { return to_oracle(kind); }, box);
}

[[nodiscard]] inline oracle::Loop to_oracle(const Polygon& polygon) {
  oracle::Loop result;
  for (const kernel::Vec3& v : polygon) result.push_back(to_oracle(v));
  return result;
}

[[nodiscard]] inline std::vector<oracle::Loop> to_oracle(const std::vector<Polygon>& polygons) {
  std::vector<oracle::Loop> result;
  for (const Polygon& polygon : polygons) result.push_back(to_oracle(polygon));
  return result;
}

[[nodiscard]] inline oracle::Polytope to_oracle(const kernel::Polytope& polytope) {
  return {to_oracle(polytope.vertices), polytope.faces};
}

[[nodiscard]] inline oracle::Occluder to_oracle(const Occluder& occluder) {
  return std::visit([](const auto& kind) -> oracle::Occluder { return to_oracle(kind); }, occluder);
}

[[nodiscard]] inline oracle::ViewRegion to_oracle(const kernel::ViewRegion& region) {
  return {to_oracle(region.box), region.kind == kernel::Viewpoint::Kind::direction};
}

[[nodiscard]] inline oracle::ShadowKind to_oracle(kernel::ShadowKind kind) {
  return kind == kernel::ShadowKind::umbra ? oracle::ShadowKind::umbra : oracle::ShadowKind::penumbra;
}

[[nodiscard]] inline oracle::Near to_oracle(Near near) {
  using Kind = oracle::Near::Kind;
  return {near == Near::farthest ? Kind::farthest : Kind::surface, {}, {}};
}

/// The near side that the kernel used. For a polygon that is not coplanar this is the support plane that the kernel chose.
/// For a refused frustum it is `farthest`, which is never a reason to refuse.
[[nodiscard]] inline oracle::Near to_oracle(Near near, const kernel::ShadowFrustumResult& made) {
  if (!made.frustum) return to_oracle(Near::farthest);
  if (!made.frustum->support_plane()) return to_oracle(near);
  const kernel::SupportPlane& plane = *made.frustum->support_plane();
  return {oracle::Near::Kind::plane, to_oracle(plane.normal), to_oracle(plane.point)};
}

}  // namespace occlude::cases
