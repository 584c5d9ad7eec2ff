// SPDX-License-Identifier: MIT
// The paper's general test (section 5.2): the relation of occludee to occluder as seen from the viewpoint, for any convex
// shapes. Reading order: 13.
//
// The paper projects both silhouettes onto the image plane. Here they stay cones with the viewpoint as apex, or prisms along
// the direction of view. So there is no division, and shapes beside or behind the eye are no special case.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "occlude/kernel/convex_polytope.h"
#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/types.h"
#include "occlude/kernel/validity.h"

namespace occlude::kernel {

struct ViewConeResult;

/// All rays from the viewpoint that meet a convex polygon or polytope: a convex cone for an eye, a convex prism for a
/// direction of view. It is a set of rays, so two cones do not meet merely because they share the eye.
class ViewCone {
 public:
  /// Refuses what ShadowFrustum::make() refuses, for the same reasons.
  [[nodiscard]] static ViewConeResult make(const Viewpoint& viewpoint, std::span<const Vec3> loop);
  [[nodiscard]] static ViewConeResult make(const Viewpoint& viewpoint, const ConvexPolytope& polytope);
  /// The rays within the side planes of a shadow frustum. If frustum.is_none() there is no cone: corners() is empty.
  explicit ViewCone(const ShadowFrustum& frustum);

  [[nodiscard]] const Viewpoint& viewpoint() const { return viewpoint_; }
  /// As ShadowFrustum::silhouette(). Edge i of the cone is its side from corner i to corner i + 1, cyclically. Empty also
  /// after a move.
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

/// The ray through a corner of the occluder or of the occludee: index in its corners().
struct OccluderCorner {
  std::size_t corner = 0;
};
struct OccludeeCorner {
  std::size_t corner = 0;
};
/// The ray in which edge `edge` of the occluder crosses the chord of the occludee from its corner 0 to its corner `corner`.
/// For corner 1 and the last corner the chord is an edge. For an eye the direction of the ray is N x M or -N x M, where N
/// and M are the normals of the planes through the eye and the edge, and through the eye and the chord.
struct Crossing {
  std::size_t edge = 0, corner = 0;
};
/// A ray that both cones share, the paper's common point O, as a corner of one or a crossing of both.
using CommonRay = std::variant<OccluderCorner, OccludeeCorner, Crossing>;

struct ConeOverlap {
  Relation relation = Relation::outside;
  std::optional<CommonRay> common;  ///< none if the relation is `outside`, or if the corners() of either are empty
  Stage stage = Stage::filter;
};

/// The exact relation of the occludee's cone to the occluder's: `inside` if it is a subset, `outside` if they share no ray,
/// else `partial`; `partial` also if the corners() of either are empty. Takes time linear in the corners of both. Allocates.
/// REQUIRES (not checked): both have the same viewpoint, and rounding to nearest (validity.h).
[[nodiscard]] ConeOverlap overlap_certified(const ViewCone& occluder, const ViewCone& occludee);

}  // namespace occlude::kernel
