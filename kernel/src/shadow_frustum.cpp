// SPDX-License-Identifier: MIT
#include "occlude/kernel/shadow_frustum.h"

#include <algorithm>
#include <utility>

#include "near_plane.h"
#include "polytope_cap.h"
#include "profile.h"
#include "rounded_plane.h"
#include "scratch.h"
#include "silhouette.h"

namespace occlude::kernel {
namespace {

/// The vertices of the silhouette in the order of their indices. Of equally far vertices the one with the lowest index then
/// counts as the farthest.
std::pmr::vector<Vec3> in_order_of_input(const ConvexPolytope& polytope, const PolytopeSilhouette& seen,
                                         std::pmr::memory_resource& memory) {
  std::pmr::vector<std::uint32_t> indices(&memory);
  for (const auto& step : seen.loop()) indices.push_back(step.vertex);
  std::sort(indices.begin(), indices.end());
  std::pmr::vector<Vec3> vertices(&memory);
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
}

void ShadowFrustum::reserve(std::size_t planes) {
  silhouette_.reserve(planes);
  recipes_.reserve(planes);
  filter_planes_.reserve(planes);
  refined_planes_.reserve(planes);
  cap_edges_.reserve(planes);
  cap_vertices_.reserve(planes);
}

void ShadowFrustum::begin(const Viewpoint& viewpoint, std::span<const Vec3> corners) {
  viewpoint_ = viewpoint;
  silhouette_.assign(corners.begin(), corners.end());
  recipes_.clear();
  filter_planes_.clear();
  refined_planes_.clear();
  filter_bound_ = profile_bound_ = {};
  cap_edges_.clear();
  cap_vertices_.clear();
  support_plane_.reset();
}

Refusal ShadowFrustum::assign(const Viewpoint& viewpoint, std::span<const Vec3> loop, Near near) {
  if (const Refusal refusal = check_rounding(); refusal != Refusal::none) return refusal;
  if (const Refusal refusal = check(loop); refusal != Refusal::none) return refusal;
  if (const Refusal refusal = check(viewpoint); refusal != Refusal::none) return refusal;
  Scratch scratch;
  const Silhouette outline = kernel::silhouette(viewpoint, loop, scratch.memory());
  if (outline.refusal != Refusal::none) return outline.refusal;

  begin(viewpoint, outline.corners);
  if (near == Near::farthest) {
    recipes_.push_back(farthest_plane(viewpoint, loop));
  } else if (const auto own = polygon_plane(silhouette_, loop)) {
    recipes_.push_back(*own);
    cap_vertices_ = silhouette_;
    for (std::size_t i = 0; i < silhouette_.size(); ++i) {
      cap_edges_.push_back(
          {silhouette_[i], silhouette_[(i + 1) % silhouette_.size()], static_cast<std::uint32_t>(i + 1), 0});
    }
  } else {
    support_plane_ = kernel::support_plane(viewpoint, silhouette_, loop);
    recipes_.push_back(exact_plane(*support_plane_));
  }
  add_sides();
  finish();
  return Refusal::none;
}

Refusal ShadowFrustum::assign(const Viewpoint& viewpoint, const ConvexPolytope& polytope, Near near,
                              PolytopeSilhouette& seen) {
  if (const Refusal refusal = check_rounding(); refusal != Refusal::none) return refusal;
  if (const Refusal refusal = check(viewpoint); refusal != Refusal::none) return refusal;
  seen.update(viewpoint, polytope);
  if (seen.loop().empty()) return Refusal::eye_in_polytope;
  Scratch scratch;
  const auto loop = loop_of(polytope, seen, scratch.memory());
  const Silhouette outline = kernel::silhouette(viewpoint, loop, scratch.memory());
  if (outline.refusal != Refusal::none) return outline.refusal;

  begin(viewpoint, outline.corners);
  if (near == Near::farthest) {
    recipes_.push_back(farthest_plane(viewpoint, in_order_of_input(polytope, seen, scratch.memory())));
    add_sides();
  } else {
    for (const std::uint32_t face : seen.turned_faces()) recipes_.push_back(inner_plane(polytope, face));
    add_sides();
    cap_vertices_.assign(polytope.vertices().begin(), polytope.vertices().end());
    append_cap_edges(polytope, seen, silhouette_, cap_edges_);
  }
  finish();
  return Refusal::none;
}

ShadowFrustumResult ShadowFrustum::make(const Viewpoint& viewpoint, std::span<const Vec3> loop, Near near) {
  ShadowFrustum frustum;
  const Refusal refusal = frustum.assign(viewpoint, loop, near);
  if (refusal != Refusal::none) return {std::nullopt, refusal};
  return {std::move(frustum), Refusal::none};
}

ShadowFrustumResult ShadowFrustum::make(const Viewpoint& viewpoint, const ConvexPolytope& polytope, Near near) {
  ShadowFrustum frustum;
  PolytopeSilhouette seen;
  const Refusal refusal = frustum.assign(viewpoint, polytope, near, seen);
  if (refusal != Refusal::none) return {std::nullopt, refusal};
  return {std::move(frustum), Refusal::none};
}

}  // namespace occlude::kernel
