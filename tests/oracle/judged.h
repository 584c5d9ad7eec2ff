// SPDX-License-Identifier: MIT
// The questions of the case generator in the oracle's types.
#pragma once

#include <variant>
#include <vector>

#include "occlude/fuzz/cases.h"
#include "occlude/kernel/shadow_frustum.h"
#include "occlude/oracle/oracle.h"

namespace occlude::oracle {

inline Point judged(const kernel::Vec3& v) { return {v.x, v.y, v.z}; }
inline Viewpoint judged(const kernel::Viewpoint& v) { return {judged(v.value), !v.is_eye()}; }

inline Relation judged(kernel::Relation relation) { return static_cast<Relation>(relation); }

inline Loop judged(const std::vector<kernel::Vec3>& vertices) {
  Loop result;
  for (const kernel::Vec3& v : vertices) result.push_back(judged(v));
  return result;
}

inline Occluder judged(const fuzz::Occluder& occluder) {
  if (const auto* polytope = std::get_if<kernel::Polytope>(&occluder)) {
    return Polytope{judged(polytope->vertices), polytope->faces};
  }
  return judged(std::get<std::vector<kernel::Vec3>>(occluder));
}

inline Near judged(kernel::Near near) {
  return {near == kernel::Near::farthest ? Near::Kind::farthest : Near::Kind::surface, {}, {}};
}

inline Near judged(const kernel::SupportPlane& plane) {
  return {Near::Kind::plane, judged(plane.normal), judged(plane.point)};
}

inline kernel::ShadowFrustumResult made_by_kernel(const fuzz::Case& c) {
  if (const auto* polygon = std::get_if<std::vector<kernel::Vec3>>(&c.occluder)) {
    return kernel::ShadowFrustum::make(c.viewpoint, *polygon, c.near);
  }
  const auto made = kernel::ConvexPolytope::make(std::get<kernel::Polytope>(c.occluder));
  if (!made.polytope) return {std::nullopt, made.refusal};
  return kernel::ShadowFrustum::make(c.viewpoint, *made.polytope, c.near);
}

/// The near side of the question, with the support plane that the kernel chose if it chose one.
inline Near judged_near(const fuzz::Case& c, const kernel::ShadowFrustumResult& made) {
  return made.frustum && made.frustum->support_plane() ? judged(*made.frustum->support_plane()) : judged(c.near);
}

inline Box judged(const fuzz::Box& box) {
  if (const auto* aabb = std::get_if<kernel::Aabb>(&box)) return Aabb{judged(aabb->min), judged(aabb->max)};
  const auto& [center, h] = std::get<kernel::Obb>(box);
  return Obb{judged(center), {judged(h[0]), judged(h[1]), judged(h[2])}};
}

}  // namespace occlude::oracle
