// SPDX-License-Identifier: MIT
// An occluder that is the union of two convex objects (section 4 of the paper): two frusta, one occluder. Reading
// order: 11.
#pragma once

#include "occlude/kernel/overlap.h"
#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/types.h"

namespace occlude::kernel {

/// What is hidden by either of two convex objects seen from one viewpoint. The union of their shadows need not be convex.
struct ShadowUnion {
  const ShadowFrustum &first, &second;  ///< must outlive this
};

/// Relation of `box` to the union, exact: `inside` also when each frustum hides a part of the box and both together all of
/// it. With NearBoundary::open `inside` is said only when true, for boxes that both shadows share at a near plane not
/// always. A frustum that is_none() adds nothing to the union, whose border is not known then: it is never `outside`.
/// REQUIRES: check(box) == Refusal::none, which is not checked, and rounding to nearest (validity.h).
[[nodiscard]] Decision overlap_certified(const ShadowUnion& shadows, const Aabb& box,
                                         NearBoundary near = NearBoundary::closed);
[[nodiscard]] Decision overlap_certified(const ShadowUnion& shadows, const Obb& box,
                                         NearBoundary near = NearBoundary::closed);

}  // namespace occlude::kernel
