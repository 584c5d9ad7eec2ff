// SPDX-License-Identifier: MIT
// The paper's general test (section 5.2): how the occludee lies to the occluder as seen from the viewpoint, whatever convex
// shape either has. Reading order: 13.
//
// Where the paper projects both silhouettes onto the image plane, here they stay cones with their apex in the viewpoint, or
// prisms along the direction of view: no division, and what lies beside or behind the eye is as good as what lies before it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "occlude/kernel/convex_polytope.h"
#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/types.h"
#include "occlude/kernel/validity.h"

namespace occlude::kernel {

struct ViewConeResult;

/// All rays from the viewpoint that meet a convex polygon or polytope: for an eye a convex cone, for a direction of view a
/// convex prism. It is a set of rays; the eye itself is none.
class ViewCone {
 public:
  /// Refuses what ShadowFrustum::make() refuses. The proof that a loop is convex takes the square of the number of corners.
  [[nodiscard]] static ViewConeResult make(const Viewpoint& viewpoint, std::span<const Vec3> loop);
  [[nodiscard]] static ViewConeResult make(const Viewpoint& viewpoint, const ConvexPolytope& polytope);
  /// The rays that the side planes of a shadow frustum bound; no cone where frustum.is_none().
  explicit ViewCone(const ShadowFrustum& frustum);

  [[nodiscard]] const Viewpoint& viewpoint() const { return viewpoint_; }
  /// As ShadowFrustum::silhouette(). Edge i of the cone is the side from corner i to corner i + 1.
  [[nodiscard]] std::span<const Vec3> corners() const { return corners_; }

 private:
  ViewCone(const Viewpoint& viewpoint, std::vector<Vec3> corners) : viewpoint_(viewpoint), corners_(std::move(corners)) {}

  Viewpoint viewpoint_;
  std::vector<Vec3> corners_;
};

/// A cone, or why there is none.
struct ViewConeResult {
  std::optional<ViewCone> cone;
  Refusal refusal = Refusal::none;
};

/// The ray through a corner of the occluder or of the occludee.
struct OccluderCorner {
  std::size_t corner = 0;
};
struct OccludeeCorner {
  std::size_t corner = 0;
};
/// The ray in which edge `edge` of the occluder crosses the chord of the occludee from its corner 0 to `corner`; for the
/// first and the last corner the chord is an edge. For an eye its direction is N x M or -N x M, N and M the normals of the
/// two.
struct Crossing {
  std::size_t edge = 0, corner = 0;
};
/// A ray that two cones share, named by what of theirs it is: the paper's common point O.
using CommonRay = std::variant<OccluderCorner, OccludeeCorner, Crossing>;

struct ConeOverlap {
  Relation relation = Relation::outside;
  std::optional<CommonRay> common;  ///< none where they are `outside`, or where one is no cone
  Stage stage = Stage::filter;
};

/// Relation of the cone of an occludee to that of an occluder, exactly: `inside` when it is a subset, `outside` when they
/// share no ray; `partial` where one is no cone. Linear in the number of corners of both. REQUIRES: both have the same
/// viewpoint, and rounding to nearest (validity.h).
[[nodiscard]] ConeOverlap overlap_certified(const ViewCone& occluder, const ViewCone& occludee);

}  // namespace occlude::kernel
