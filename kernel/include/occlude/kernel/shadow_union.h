// SPDX-License-Identifier: MIT
// An occluder that is the union of two convex objects (section 4 of the paper): two frusta, one occluder. Reading order: 11.
#pragma once

#include "occlude/kernel/overlap.h"
#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/types.h"

namespace occlude::kernel {

/// The union of two shadows, usually of one viewpoint. It need not be convex.
struct ShadowUnion {
  const ShadowFrustum &first, &second;  ///< references: both must outlive this, so never temporaries
};

/// Relation of `box` to the union.
/// 1. NearBoundary::closed: exact. `inside` also if neither shadow contains the box but both together do.
/// 2. NearBoundary::open: `inside` is always true, but may be missed (`partial`) for a box that meets a near plane and that
///    neither shadow contains alone. `outside` is as in 1.
/// 3. A frustum that is_none() adds nothing. Then the answer is never `outside`.
/// REQUIRES (not checked): check(box) == Refusal::none, and rounding to nearest (validity.h).
[[nodiscard]] Decision overlap_certified(const ShadowUnion& shadows, const Aabb& box,
                                         NearBoundary near = NearBoundary::closed);
[[nodiscard]] Decision overlap_certified(const ShadowUnion& shadows, const Obb& box,
                                         NearBoundary near = NearBoundary::closed);

}  // namespace occlude::kernel
