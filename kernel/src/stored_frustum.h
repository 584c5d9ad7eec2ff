// SPDX-License-Identifier: MIT
// How a shadow frustum is stored: what the tests read of it. build_frustum.h makes it. Reading order: 6.
#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <optional>
#include <span>
#include <vector>

#include "coarse_plane.h"
#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/types.h"
#include "planes.h"

namespace occlude::kernel {

/// An edge of the near side that is an edge of the occluder. N_left x N_right points from `from` to `to`, N being normals of
/// the planes `left` and `right`, which are indices in StoredFrustum::recipes.
struct CapEdge {
  Vec3 from, to;
  std::uint32_t left, right;

  friend bool operator==(const CapEdge&, const CapEdge&) = default;
};

/// The planes come in three forms of the same size and order: recipes, filter_planes and refined_planes. First near_count
/// planes of the near side, then one per side, plane_count in all; after these, if has_profile, the planes of the profile
/// along the coordinate axes (profile.h). What stage 1 reads comes first.
struct StoredFrustum {
  /// The point that the planes in floats and doubles are relative to: the eye, or silhouette[0] for a direction.
  Vec3 origin;
  std::size_t plane_count = 0;  ///< 0: there is no frustum
  std::size_t near_count = 0;
  std::vector<CoarsePlane> coarse_planes;    ///< in floats, the first plane_count alone (kCoarseWidth)
  CoarseBound coarse_bound;                  ///< of these
  std::vector<FilterPlane> filter_planes;    ///< in doubles
  FilterBound filter_bound, profile_bound;   ///< of the first plane_count planes, and of those of the profile
  std::vector<RefinedPlane> refined_planes;  ///< what the doubles lost
  std::vector<PlaneRecipe> recipes;          ///< exact
  Viewpoint viewpoint;
  std::vector<Vec3> silhouette;
  std::vector<CapEdge> cap_edges;  ///< the edges of the near side if it is the occluder, else none
  /// The corners of the polygon, or all vertices of the polytope, if the near side is the occluder; else none.
  std::vector<Vec3> cap_vertices;
  std::optional<SupportPlane> support_plane;
  bool has_profile = false;

  [[nodiscard]] std::span<const FilterPlane> own_planes() const { return {filter_planes.data(), plane_count}; }
  [[nodiscard]] std::span<const FilterPlane> profile_planes() const { return std::span(filter_planes).subspan(plane_count); }
  /// Whether the near side is a single plane that cuts the edges of the frustum, and not the occluder itself.
  [[nodiscard]] bool is_cut() const { return cap_edges.empty(); }
};

inline const StoredFrustum& ShadowFrustum::own() const {
  return *std::launder(reinterpret_cast<const StoredFrustum*>(stored_));
}

/// What a frustum stores, or null if it is none.
[[nodiscard]] inline const StoredFrustum* stored(const ShadowFrustum& frustum) {
  const StoredFrustum& own = frustum.own();
  return own.plane_count != 0 ? &own : nullptr;
}

}  // namespace occlude::kernel
