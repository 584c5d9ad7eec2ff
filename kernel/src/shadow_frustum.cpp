// SPDX-License-Identifier: MIT
#include "occlude/kernel/shadow_frustum.h"

#include <algorithm>
#include <utility>

#include "near_plane.h"
#include "plain_edges.h"
#include "polytope_silhouette.h"
#include "profile.h"
#include "rounded_plane.h"
#include "silhouette.h"

namespace occlude::kernel {
namespace {

/// Where equally far vertices of a silhouette are told apart by their index.
std::vector<Vec3> in_order_of_input(const ConvexPolytope& polytope, const PolytopeSilhouette& seen) {
  std::vector<std::uint32_t> indices;
  for (const auto& step : seen.loop) indices.push_back(step.vertex);
  std::sort(indices.begin(), indices.end());
  std::vector<Vec3> vertices;
  for (const std::uint32_t i : indices) vertices.push_back(polytope.vertices()[i]);
  return vertices;
}

}  // namespace

void ShadowFrustum::add_sides() {
  const std::size_t n = silhouette_.size();
  origin_ = viewpoint_.is_eye() ? viewpoint_.value : silhouette_[0];
  near_count_ = recipes_.size();
  plane_count_ = near_count_ + n;
  for (std::size_t i = 0; i < n; ++i) recipes_.push_back(side_plane(viewpoint_, silhouette_[i], silhouette_[(i + 1) % n]));
}

void ShadowFrustum::finish() {
  const auto sign_along = [&](std::size_t plane, std::size_t axis) {
    const auto question = [&]<class A>(A& arithmetic) {
      return arithmetic.sign(normal<A>(plane_of(*this, plane))[static_cast<int>(axis)]);
    };
    return certified(question);
  };
  const auto keep = [&](const PlaneRecipe& recipe) {
    recipes_.push_back(recipe);
    return false;
  };
  static_cast<void>(visit_profile(*this, BoxAxes{}, sign_along, keep));
  filter_planes_.reserve(recipes_.size());
  refined_planes_.reserve(recipes_.size());
  for (const PlaneRecipe& recipe : recipes_) {
    const auto [filter, bound, refined] = rounded(coefficients<DoubleDoubleArithmetic>(*this, recipe));
    FilterBound& common = filter_planes_.size() < plane_count_ ? filter_bound_ : profile_bound_;
    common = {std::max(common.slope, bound.slope), std::max(common.base, bound.base)};
    filter_planes_.push_back(filter);
    refined_planes_.push_back(refined);
  }
  plain_edges_ = kernel::plain_edges(*this);
}

ShadowFrustumResult ShadowFrustum::make(const Viewpoint& viewpoint, std::span<const Vec3> loop, Near near) {
  if (const Refusal refusal = check(loop); refusal != Refusal::none) return {std::nullopt, refusal};
  if (const Refusal refusal = check(viewpoint); refusal != Refusal::none) return {std::nullopt, refusal};
  Silhouette outline = kernel::silhouette(viewpoint, loop);
  if (outline.refusal != Refusal::none) return {std::nullopt, outline.refusal};

  ShadowFrustum frustum;
  frustum.viewpoint_ = viewpoint;
  frustum.silhouette_ = std::move(outline.corners);
  const std::vector<Vec3>& corners = frustum.silhouette_;
  if (near == Near::farthest) {
    frustum.recipes_.push_back(farthest_plane(viewpoint, loop));
  } else if (const auto own = polygon_plane(corners, loop)) {
    frustum.recipes_.push_back(*own);
    frustum.cap_vertices_ = corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      frustum.cap_edges_.push_back({corners[i], corners[(i + 1) % corners.size()], static_cast<std::uint32_t>(i + 1), 0});
    }
  } else {
    frustum.support_plane_ = kernel::support_plane(viewpoint, corners, loop);
    frustum.recipes_.push_back(exact_plane(*frustum.support_plane_));
  }
  frustum.add_sides();
  frustum.finish();
  return {std::move(frustum), Refusal::none};
}

ShadowFrustumResult ShadowFrustum::make(const Viewpoint& viewpoint, const ConvexPolytope& polytope, Near near) {
  if (const Refusal refusal = check(viewpoint); refusal != Refusal::none) return {std::nullopt, refusal};
  const PolytopeSilhouette seen = kernel::silhouette(viewpoint, polytope);
  if (seen.loop.empty()) return {std::nullopt, Refusal::eye_in_polytope};
  Silhouette outline = kernel::silhouette(viewpoint, loop_of(polytope, seen));
  if (outline.refusal != Refusal::none) return {std::nullopt, outline.refusal};

  ShadowFrustum frustum;
  frustum.viewpoint_ = viewpoint;
  frustum.silhouette_ = std::move(outline.corners);
  if (near == Near::farthest) {
    frustum.recipes_.push_back(farthest_plane(viewpoint, in_order_of_input(polytope, seen)));
    frustum.add_sides();
  } else {
    for (const std::uint32_t face : seen.turned_faces) frustum.recipes_.push_back(inner_plane(polytope, face));
    frustum.add_sides();
    frustum.cap_vertices_.assign(polytope.vertices().begin(), polytope.vertices().end());
    frustum.cap_edges_ = kernel::cap_edges(polytope, seen, frustum.silhouette_);
  }
  frustum.finish();
  return {std::move(frustum), Refusal::none};
}

}  // namespace occlude::kernel
