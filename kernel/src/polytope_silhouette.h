// SPDX-License-Identifier: MIT
// What a viewpoint sees of a convex polytope: the faces turned to it and the loop of edges around them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "occlude/kernel/convex_polytope.h"
#include "occlude/kernel/shadow_frustum.h"

namespace occlude::kernel {

struct PolytopeSilhouette {
  /// A vertex of the loop and the turned face at the edge from it to the next.
  struct Step {
    std::uint32_t vertex, face;
  };
  std::vector<std::uint32_t> turned_faces;
  std::vector<Step> loop;  ///< running as ShadowFrustum::silhouette(); empty when the viewpoint is in the polytope
};

[[nodiscard]] PolytopeSilhouette silhouette(const Viewpoint& viewpoint, const ConvexPolytope& polytope);

/// The vertices of its loop.
[[nodiscard]] std::vector<Vec3> loop_of(const ConvexPolytope& polytope, const PolytopeSilhouette& seen);

/// The plane of a face, its inner side that of the polytope.
[[nodiscard]] ExactPlane inner_plane(const ConvexPolytope& polytope, std::uint32_t face);

/// The edges of the near side of a frustum whose planes are those of the turned faces, then those of the sides of `corners`.
[[nodiscard]] std::vector<ShadowFrustum::CapEdge> cap_edges(const ConvexPolytope& polytope, const PolytopeSilhouette& seen,
                                                            std::span<const Vec3> corners);

}  // namespace occlude::kernel
