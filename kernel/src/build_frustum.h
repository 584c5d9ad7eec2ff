// SPDX-License-Identifier: MIT
// How a shadow frustum is built (section 5).
#pragma once

#include <span>

#include "occlude/kernel/convex_polytope.h"
#include "occlude/kernel/polytope_silhouette.h"
#include "stored_frustum.h"

namespace occlude::kernel {

/// As ShadowFrustum::assign(), into a frustum as it is stored.
[[nodiscard]] Refusal build(StoredFrustum& frustum, const Viewpoint& viewpoint, std::span<const Vec3> loop, Near near);
[[nodiscard]] Refusal build(StoredFrustum& frustum, const Viewpoint& viewpoint, const ConvexPolytope& polytope, Near near,
                            PolytopeSilhouette& seen);

/// Rounds the planes that are not yet rounded. `common` becomes a bound for all of them.
void round_planes(StoredFrustum& frustum, FilterBound& common);

/// As ShadowFrustum::prepare_overlap().
void add_profile(StoredFrustum& frustum);

/// Removes the frustum and keeps its memory.
void clear(StoredFrustum& frustum);

}  // namespace occlude::kernel
