// SPDX-License-Identifier: MIT
// The kernel's question: is this box inside a shadow, across its border, or outside (section 5)? Reading order: 9.
#pragma once

#include "occlude/kernel/operations.h"
#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/types.h"

namespace occlude::kernel {

/// An answer, and the stage that gave it.
struct Decision {
  Relation relation = Relation::partial;
  Stage stage = Stage::filter;
};

/// Whether a box that touches the near side from within may be `inside`. `closed`, the definition of the shadow frustum:
/// yes. `open`: no, it is `partial`. Culling uses `open`, so that what is coplanar with an occluder is drawn.
enum class NearBoundary { closed, open };

/// Relation of `box` to `frustum`; `partial` (stage `filter`) if frustum.is_none(). REQUIRES (not checked): check(box) ==
/// Refusal::none, and rounding to nearest (validity.h). Nothing is allocated.
///
/// Properties of `certified`:
/// (1) overlap: exactly the relation of the two closed point sets. A box that only touches the frustum is `partial`, or
///     `inside` if all of it lies in the border.
/// (2) conservative: finds every `inside`. `outside` is always true, but is found only where a single plane of the frustum
///     separates the box from it; all else is `partial`.
/// (3) The relation depends on the point sets alone: permuting axes, mirroring, scaling by a power of two, exact
///     translation, repeated or collinear vertices change nothing. Nor does the direction or the start of the loop, with one
///     exception: with Near::farthest and several equally far vertices, the first in the input determines the near plane.
/// (4) A box within a box that is `inside` is `inside`.
/// `plain` has none of these properties where rounding makes it wrong.
[[nodiscard]] Decision overlap_certified(const ShadowFrustum& frustum, const Aabb& box,
                                         NearBoundary near = NearBoundary::closed);
[[nodiscard]] Decision overlap_certified(const ShadowFrustum& frustum, const Obb& box,
                                         NearBoundary near = NearBoundary::closed);
[[nodiscard]] Decision conservative_certified(const ShadowFrustum& frustum, const Aabb& box,
                                              NearBoundary near = NearBoundary::closed);
[[nodiscard]] Decision conservative_certified(const ShadowFrustum& frustum, const Obb& box,
                                              NearBoundary near = NearBoundary::closed);
[[nodiscard]] Relation overlap_plain(const ShadowFrustum& frustum, const Aabb& box,
                                     NearBoundary near = NearBoundary::closed);
[[nodiscard]] Relation overlap_plain(const ShadowFrustum& frustum, const Obb& box, NearBoundary near = NearBoundary::closed);
[[nodiscard]] Relation conservative_plain(const ShadowFrustum& frustum, const Aabb& box,
                                          NearBoundary near = NearBoundary::closed);
[[nodiscard]] Relation conservative_plain(const ShadowFrustum& frustum, const Obb& box,
                                          NearBoundary near = NearBoundary::closed);

/// The same, with the variant chosen at run time. The stage of `plain` is always `filter`.
[[nodiscard]] Decision decide(const ShadowFrustum& frustum, const Aabb& box, Arithmetic arithmetic, Test test,
                              NearBoundary near = NearBoundary::closed);
[[nodiscard]] Decision decide(const ShadowFrustum& frustum, const Obb& box, Arithmetic arithmetic, Test test,
                              NearBoundary near = NearBoundary::closed);

/// What the test costs on this box with NearBoundary::closed, counted while it runs (Table 1). `tests` is 1. For `certified`
/// only the filter is counted, which nearly always decides. As in the paper, building the frustum is not counted. REQUIRES:
/// as above.
[[nodiscard]] Operations count_operations(const ShadowFrustum& frustum, const Aabb& box, Arithmetic arithmetic, Test test);
[[nodiscard]] Operations count_operations(const ShadowFrustum& frustum, const Obb& box, Arithmetic arithmetic, Test test);

}  // namespace occlude::kernel
