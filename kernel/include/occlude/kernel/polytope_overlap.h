// SPDX-License-Identifier: MIT
// The kernel's question about a convex polytope instead of a box (section 5.2). Reading order: 13.
#pragma once

#include "occlude/kernel/convex_polytope.h"
#include "occlude/kernel/overlap.h"
#include "occlude/kernel/shadow_frustum.h"

namespace occlude::kernel {

/// Relation of the polytope to the frustum, exactly, as the function of the same name answers for boxes. The viewpoint may
/// lie in the polytope. REQUIRES: rounding to nearest (validity.h). `stage` is that of the answer; the polytope's silhouette
/// is preparation, like the frustum's.
[[nodiscard]] Decision overlap_certified(const ShadowFrustum& frustum, const ConvexPolytope& occludee,
                                         NearBoundary near = NearBoundary::closed);

}  // namespace occlude::kernel
