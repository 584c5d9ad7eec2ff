// SPDX-License-Identifier: MIT
#include "build_frustum.h"

#include <algorithm>
#include <memory_resource>

#include "near_plane.h"
#include "polytope_cap.h"
#include "profile.h"
#include "rounded_plane.h"
#include "scratch.h"
#include "silhouette.h"

namespace occlude::kernel {
namespace {

/// The vertices of the silhouette in the order of the polytope's vertices: of equally far ones, the first is taken.
std::pmr::vector<Vec3> in_order_of_input(const ConvexPolytope& polytope, const PolytopeSilhouette& seen,
                                         std::pmr::memory_resource& memory) {
  std::pmr::vector<std::uint32_t> indices(&memory);
  for (const auto& step : seen.loop()) indices.push_back(step.vertex);
  std::sort(indices.begin(), indices.end());
  std::pmr::vector<Vec3> vertices(&memory);
  for (const std::uint32_t i : indices) vertices.push_back(polytope.vertices()[i]);
  return vertices;
}

void begin(StoredFrustum& frustum, const Viewpoint& viewpoint, std::span<const Vec3> corners) {
  clear(frustum);
  frustum.viewpoint = viewpoint;
  frustum.silhouette.assign(corners.begin(), corners.end());
}

/// Adds the planes of the sides. REQUIRES: those of the near side were added.
void add_sides(StoredFrustum& frustum) {
  const auto& corners = frustum.silhouette;
  const std::size_t n = corners.size();
  frustum.origin = frustum.viewpoint.is_eye() ? frustum.viewpoint.value : corners[0];
  frustum.near_count = frustum.recipes.size();
  frustum.plane_count = frustum.near_count + n;
  for (std::size_t i = 0; i < n; ++i) {
    frustum.recipes.push_back(side_plane(frustum.viewpoint, corners[i], corners[(i + 1) % n]));
  }
}

/// Rounds the frustum's own planes to floats. REQUIRES: they are rounded to doubles.
void round_to_floats(StoredFrustum& frustum) {
  frustum.coarse_planes.reserve((frustum.plane_count + kCoarseWidth - 1) / kCoarseWidth * kCoarseWidth);
  for (const FilterPlane& plane : frustum.own_planes()) {
    frustum.coarse_planes.push_back(coarse(plane, frustum.filter_bound, frustum.coarse_bound));
  }
  while (frustum.coarse_planes.size() % kCoarseWidth != 0) frustum.coarse_planes.push_back(frustum.coarse_planes.back());
}

}  // namespace

void round_planes(StoredFrustum& frustum, FilterBound& common) {
  frustum.filter_planes.reserve(frustum.recipes.size());
  frustum.refined_planes.reserve(frustum.recipes.size());
  while (frustum.filter_planes.size() < frustum.recipes.size()) {
    const PlaneRecipe& recipe = frustum.recipes[frustum.filter_planes.size()];
    const auto [filter, bound, refined] = rounded(coefficients<DoubleDoubleArithmetic>(frustum, recipe));
    common = {std::max(common.slope, bound.slope), std::max(common.base, bound.base)};
    frustum.filter_planes.push_back(filter);
    frustum.refined_planes.push_back(refined);
  }
}

void clear(StoredFrustum& frustum) {
  frustum.viewpoint = {};
  frustum.origin = {};
  frustum.near_count = frustum.plane_count = 0;
  frustum.silhouette.clear();
  frustum.recipes.clear();
  frustum.coarse_planes.clear();
  frustum.coarse_bound = {};
  frustum.filter_planes.clear();
  frustum.refined_planes.clear();
  frustum.filter_bound = frustum.profile_bound = {};
  frustum.has_profile = false;
  frustum.cap_edges.clear();
  frustum.cap_vertices.clear();
  frustum.support_plane.reset();
}

Refusal build(StoredFrustum& frustum, const Viewpoint& viewpoint, std::span<const Vec3> loop, Near near) {
  if (const Refusal refusal = check_rounding(); refusal != Refusal::none) return refusal;
  if (const Refusal refusal = check(loop); refusal != Refusal::none) return refusal;
  if (const Refusal refusal = check(viewpoint); refusal != Refusal::none) return refusal;
  Scratch scratch;
  const Silhouette outline = silhouette(viewpoint, loop, scratch.memory());
  if (outline.refusal != Refusal::none) return outline.refusal;

  begin(frustum, viewpoint, outline.corners);
  if (near == Near::farthest) {
    frustum.recipes.push_back(farthest_plane(viewpoint, loop));
  } else if (const auto own = polygon_plane(frustum.silhouette, loop)) {
    frustum.recipes.push_back(*own);
    const auto& corners = frustum.cap_vertices = frustum.silhouette;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      frustum.cap_edges.push_back({corners[i], corners[(i + 1) % corners.size()], static_cast<std::uint32_t>(i + 1), 0});
    }
  } else {
    frustum.support_plane = support_plane(viewpoint, frustum.silhouette, loop);
    frustum.recipes.push_back(exact_plane(*frustum.support_plane));
  }
  add_sides(frustum);
  round_planes(frustum, frustum.filter_bound);
  round_to_floats(frustum);
  return Refusal::none;
}

Refusal build(StoredFrustum& frustum, const Viewpoint& viewpoint, const ConvexPolytope& polytope, Near near,
              PolytopeSilhouette& seen) {
  if (const Refusal refusal = check_rounding(); refusal != Refusal::none) return refusal;
  if (const Refusal refusal = check(viewpoint); refusal != Refusal::none) return refusal;
  seen.update(viewpoint, polytope);
  if (seen.loop().empty()) return Refusal::eye_in_polytope;
  Scratch scratch;
  const auto loop = loop_of(polytope, seen, scratch.memory());
  const Silhouette outline = silhouette(viewpoint, loop, scratch.memory());
  if (outline.refusal != Refusal::none) return outline.refusal;

  begin(frustum, viewpoint, outline.corners);
  if (near == Near::farthest) {
    frustum.recipes.push_back(farthest_plane(viewpoint, in_order_of_input(polytope, seen, scratch.memory())));
    add_sides(frustum);
  } else {
    for (const std::uint32_t face : seen.turned_faces()) frustum.recipes.push_back(inner_plane(polytope, face));
    add_sides(frustum);
    frustum.cap_vertices.assign(polytope.vertices().begin(), polytope.vertices().end());
    append_cap_edges(polytope, seen, frustum.silhouette, frustum.cap_edges);
  }
  round_planes(frustum, frustum.filter_bound);
  round_to_floats(frustum);
  return Refusal::none;
}

void add_profile(StoredFrustum& frustum) {
  if (frustum.has_profile || frustum.plane_count == 0) return;
  const auto sign_along = [&](std::size_t plane, std::size_t axis) {
    const auto question = [&]<class A>(A& arithmetic) {
      return arithmetic.sign(normal<A>(plane_of(frustum, plane))[static_cast<int>(axis)]);
    };
    return certified(question);
  };
  const auto keep = [&](const PlaneRecipe& recipe) {
    frustum.recipes.push_back(recipe);
    return false;
  };
  static_cast<void>(visit_profile(frustum, BoxAxes{}, sign_along, keep));
  round_planes(frustum, frustum.profile_bound);
  frustum.has_profile = true;
}

}  // namespace occlude::kernel
