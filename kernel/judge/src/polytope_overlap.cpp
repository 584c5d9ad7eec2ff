// SPDX-License-Identifier: MIT
// The near side of the frustum comes first. An occludee before it is `outside`, and an occludee beyond it is decided by the
// cones. An occludee across it, or about the viewpoint, cannot be `inside`. It meets the frustum when an edge of either
// meets the other: the frustum is unbounded, so it cannot lie within a polytope. Edges are clipped in the manner of Cyrus
// and Beck (segment_clip.h) by planes of degree three. So the comparison of clip parameters is of degree six, the highest
// degree that stays exact.
#include "occlude/kernel/polytope_overlap.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "occlude/kernel/view_cone.h"
#include "plane_coefficients.h"
#include "polytope_cap.h"
#include "segment_clip.h"

namespace occlude::kernel {
namespace {

/// The position of the occludee relative to the near side.
struct NearSide {
  bool is_before = false;  ///< all of it is strictly before one of the near planes
  int least = 1;           ///< the least sign of a near plane at a vertex: 1 when all of it is strictly beyond all of them
};

NearSide near_side(const StoredFrustum& frustum, const ConvexPolytope& occludee, Stage& stage) {
  NearSide result;
  for (std::size_t plane = 0; plane < frustum.near_count; ++plane) {
    int greatest = -1;
    for (const Vec3& v : occludee.vertices()) {
      const int sign = sign_at(plane_of(frustum, plane), v, &stage);
      greatest = std::max(greatest, sign);
      result.least = std::min(result.least, sign);
    }
    if (greatest < 0) return {.is_before = true, .least = -1};
  }
  return result;
}

/// A segment from `from` to `from` + `along`, or a ray from `from` along `along`.
template <class A>
struct Edge {
  Vec3 from;
  Vector3<typename A::Number> along;
  bool is_ray = false;
};

/// Whether the edge shares a point with the intersection of the inner sides of planes. REQUIRES: for a ray, that
/// intersection is bounded. Then a ray along one plane, which meets that plane at infinity, leaves the intersection by
/// another.
template <class A>
bool meets(A& arithmetic, const Edge<A>& edge, std::span<const ExactPlane> planes) {
  SegmentClip<A> left(arithmetic);
  for (const ExactPlane& plane : planes) {
    const auto n = normal<A>(plane);
    const auto at_from = dot(n, difference<A>(edge.from, plane.origin)), along = dot(n, edge.along);
    left.clip(at_from, edge.is_ray ? along : at_from + along);
    if (left.empty()) return false;
  }
  return true;
}

std::vector<ExactPlane> planes_of(const StoredFrustum& frustum) {
  std::vector<ExactPlane> planes;
  for (std::size_t i = 0; i < frustum.plane_count; ++i) planes.push_back(plane_of(frustum, i));
  return planes;
}

std::vector<ExactPlane> planes_of(const ConvexPolytope& polytope) {
  std::vector<ExactPlane> planes;
  for (std::uint32_t face = 0; face < polytope.faces().size(); ++face) planes.push_back(inner_plane(polytope, face));
  return planes;
}

bool edge_meets_frustum(const StoredFrustum& frustum, const ConvexPolytope& occludee, Stage& stage) {
  const std::vector<ExactPlane> planes = planes_of(frustum);
  const auto v = occludee.vertices();
  return std::any_of(occludee.edges().begin(), occludee.edges().end(), [&](const ConvexPolytope::Edge& edge) {
    const auto question = [&]<class A>(A& arithmetic) {
      return meets<A>(arithmetic, {v[edge.from], difference<A>(v[edge.to], v[edge.from])}, planes);
    };
    return certified(question, &stage);
  });
}

/// Whether an edge of the frustum meets the occludee, when none of the occludee meets the frustum: then each face's plane
/// cuts the frustum, if at all within that face, in a polygon whose corners lie on edges of the frustum. Where one plane
/// cuts the near side, the polygon has a corner on a ray; else edges of the near side are edges of the occluder.
bool edge_meets_occludee(const StoredFrustum& frustum, const ConvexPolytope& occludee, Stage& stage) {
  const std::vector<ExactPlane> faces = planes_of(occludee);
  const auto& cap_edges = frustum.cap_edges;
  const bool cap_meets = std::any_of(cap_edges.begin(), cap_edges.end(), [&](const CapEdge& edge) {
    const auto question = [&]<class A>(A& arithmetic) {
      return meets<A>(arithmetic, {edge.from, difference<A>(edge.to, edge.from)}, faces);
    };
    return certified(question, &stage);
  });
  if (cap_meets) return true;

  // A corner of the silhouette is never beyond the near side, so the ray of the frustum starts there or later.
  std::vector<ExactPlane> planes = faces;
  for (std::size_t i = 0; i < frustum.near_count; ++i) planes.push_back(plane_of(frustum, i));
  for (std::size_t corner = 0; corner < frustum.silhouette.size(); ++corner) {
    const auto question = [&]<class A>(A& arithmetic) {
      return meets<A>(arithmetic, {frustum.silhouette[corner], ray<A>(frustum, corner), true}, planes);
    };
    if (certified(question, &stage)) return true;
  }
  return false;
}

}  // namespace

Decision overlap_certified(const ShadowFrustum& shadow, const ConvexPolytope& occludee, NearBoundary near) {
  Stage stage = Stage::filter;
  const StoredFrustum* const frustum = stored(shadow);
  if (!frustum) return {Relation::partial, stage};
  const NearSide side = near_side(*frustum, occludee, stage);
  if (side.is_before) return {Relation::outside, stage};
  if (const auto seen = ViewCone::make(frustum->viewpoint, occludee).cone) {
    const ConeOverlap cones = overlap_certified(ViewCone(shadow), *seen);
    if (cones.stage == Stage::exact) stage = Stage::exact;
    if (cones.relation == Relation::outside) return {Relation::outside, stage};
    const int least_inner = near == NearBoundary::open ? 1 : 0;
    if (cones.relation == Relation::inside && side.least >= least_inner) return {Relation::inside, stage};
    if (side.least >= 0) return {Relation::partial, stage};
  }
  const bool meet = edge_meets_frustum(*frustum, occludee, stage) || edge_meets_occludee(*frustum, occludee, stage);
  return {meet ? Relation::partial : Relation::outside, stage};
}

}  // namespace occlude::kernel
