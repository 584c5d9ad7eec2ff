// SPDX-License-Identifier: MIT
// The near side of a polytope's shadow: the faces turned to the viewpoint, and their edges.
#pragma once

#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

#include "occlude/kernel/polytope_silhouette.h"
#include "stored_frustum.h"

namespace occlude::kernel {

/// The vertices of the silhouette's loop.
[[nodiscard]] std::pmr::vector<Vec3> loop_of(const ConvexPolytope& polytope, const PolytopeSilhouette& seen,
                                             std::pmr::memory_resource& memory);

/// The plane of a face. Its inner side is the side of the polytope.
[[nodiscard]] ExactPlane inner_plane(const ConvexPolytope& polytope, std::uint32_t face);

/// Appends the edges of the near side of a frustum. REQUIRES: the planes of the frustum are those of the turned faces, then
/// those of the sides between `corners`.
void append_cap_edges(const ConvexPolytope& polytope, const PolytopeSilhouette& seen, std::span<const Vec3> corners,
                      std::vector<CapEdge>& edges);

}  // namespace occlude::kernel
