// SPDX-License-Identifier: MIT
#include "occlude/kernel/view_cone.h"

#include "cone_sweep.h"
#include "plane_coefficients.h"
#include "polytope_cap.h"
#include "scratch.h"
#include "silhouette.h"

namespace occlude::kernel {

ViewCone::ViewCone(const ShadowFrustum& frustum)
    : viewpoint_(frustum.viewpoint()), corners_(frustum.silhouette().begin(), frustum.silhouette().end()) {}

ViewConeResult ViewCone::make(const Viewpoint& viewpoint, std::span<const Vec3> loop) {
  if (const Refusal refusal = check_rounding(); refusal != Refusal::none) return {std::nullopt, refusal};
  if (const Refusal refusal = check(loop); refusal != Refusal::none) return {std::nullopt, refusal};
  if (const Refusal refusal = check(viewpoint); refusal != Refusal::none) return {std::nullopt, refusal};
  Scratch scratch;
  const auto [corners, refusal] = silhouette(viewpoint, loop, scratch.memory());
  if (refusal != Refusal::none) return {std::nullopt, refusal};
  return {ViewCone(viewpoint, {corners.begin(), corners.end()}), Refusal::none};
}

ViewConeResult ViewCone::make(const Viewpoint& viewpoint, const ConvexPolytope& polytope) {
  if (const Refusal refusal = check_rounding(); refusal != Refusal::none) return {std::nullopt, refusal};
  if (const Refusal refusal = check(viewpoint); refusal != Refusal::none) return {std::nullopt, refusal};
  PolytopeSilhouette seen;
  seen.update(viewpoint, polytope);
  if (seen.loop().empty()) return {std::nullopt, Refusal::eye_in_polytope};
  Scratch scratch;
  return make(viewpoint, loop_of(polytope, seen, scratch.memory()));
}

ConeOverlap overlap_certified(const ViewCone& occluder, const ViewCone& occludee) {
  if (occluder.corners().empty() || occludee.corners().empty()) return {Relation::partial, std::nullopt, Stage::filter};
  Stage stage = Stage::filter;
  const auto orientation = [&](const Vec3& p, const Vec3& q, const Vec3& r) {
    return sign_at(side_plane(occluder.viewpoint(), p, q), r, &stage);
  };
  ConeOverlap result = ConeSweep(orientation, occluder.corners(), occludee.corners()).overlap();
  result.stage = stage;
  return result;
}

}  // namespace occlude::kernel
