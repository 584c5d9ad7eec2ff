// SPDX-License-Identifier: MIT
// The kernel's question about a convex polytope instead of a box (section 5.2). Reading order: 13.
#pragma once

#include "occlude/kernel/convex_polytope.h"
#include "occlude/kernel/overlap.h"
#include "occlude/kernel/shadow_frustum.h"

namespace occlude::kernel {

/// The exact relation of the polytope to the frustum; properties as of overlap_certified() for boxes (overlap.h). The
/// viewpoint may lie in the polytope. `stage` does not count the silhouette of the polytope, which is preparation, as that
/// of the frustum is. Allocates. REQUIRES: a polytope of ConvexPolytope::make(), and rounding to nearest (validity.h).
[[nodiscard]] Decision overlap_certified(const ShadowFrustum& frustum, const ConvexPolytope& occludee,
                                         NearBoundary near = NearBoundary::closed);

}  // namespace occlude::kernel
