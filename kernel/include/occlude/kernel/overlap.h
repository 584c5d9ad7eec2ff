// SPDX-License-Identifier: MIT
// The kernel's question: does this box lie in this shadow, across its border, or outside? Reading order: 9.
#pragma once

#include "occlude/kernel/operations.h"
#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/types.h"

namespace occlude::kernel {

struct Decision {
  Relation relation = Relation::partial;
  Stage stage = Stage::filter;
};

/// Whether a box that touches the near plane may be `inside`. Culling takes `open`: what is coplanar with an occluder is
/// drawn. The definition of the shadow frustum is `closed`.
enum class NearBoundary { closed, open };

/// Relation of `box` to `frustum`; `partial` where frustum.is_none(). REQUIRES: check(box) == Refusal::none, which is not
/// checked, and rounding to nearest (validity.h).
///
/// Properties of `certified`:
/// (1) overlap: exactly the relation of the two sets of real numbers, touching being `partial` unless the box is inside.
/// (2) conservative: `inside` and `outside` are exactly true; whatever no single plane of the frustum decides is `partial`.
/// (3) The answer depends on the sets alone: permuting axes, mirroring, scaling by a power of two, exact translation,
///     repeated or collinear vertices change nothing. Nor does it matter which way round the loop goes and where it begins:
///     with Near::surface never, with Near::farthest unless several vertices of the silhouette are exactly as far as the
///     farthest. Of these the first in the input gives the near plane, and the order of the input decides which that is.
/// (4) A box within another that is `inside` is `inside`.
/// `plain` is wrong where rounding makes it so.
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

/// The same, chosen at run time; the stage of `plain` is `filter`.
[[nodiscard]] Decision decide(const ShadowFrustum& frustum, const Aabb& box, Arithmetic arithmetic, Test test,
                              NearBoundary near = NearBoundary::closed);
[[nodiscard]] Decision decide(const ShadowFrustum& frustum, const Obb& box, Arithmetic arithmetic, Test test,
                              NearBoundary near = NearBoundary::closed);

/// What the test costs on this box, counted operation by operation as it runs (Table 1); of `certified` the filter, which
/// nearly always is all there is. The frustum's own preparation is not counted, as in the paper.
[[nodiscard]] Operations count_operations(const ShadowFrustum& frustum, const Aabb& box, Arithmetic arithmetic, Test test);
[[nodiscard]] Operations count_operations(const ShadowFrustum& frustum, const Obb& box, Arithmetic arithmetic, Test test);

}  // namespace occlude::kernel
