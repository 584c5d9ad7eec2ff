// SPDX-License-Identifier: MIT
// When a box may be culled by a shadow.
#pragma once

#include "camera/shadow_margin.h"
#include "occlude/kernel/overlap.h"
#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/shadow_union.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// How the kernel is asked.
struct Asked {
  kernel::Arithmetic arithmetic = kernel::Arithmetic::certified;
  kernel::Test test = kernel::Test::conservative;
};

/// Asks about one shadow, or about two together, for which the answer is always exact. The near plane is open.
template <class AnyBox>
[[nodiscard]] kernel::Decision decide_open(const kernel::ShadowFrustum& shadow, const AnyBox& box, const Asked& asked) {
  return kernel::decide(shadow, box, asked.arithmetic, asked.test, kernel::NearBoundary::open);
}
template <class AnyBox>
[[nodiscard]] kernel::Decision decide_open(const kernel::ShadowUnion& shadows, const AnyBox& box, const Asked&) {
  return kernel::overlap_certified(shadows, box, kernel::NearBoundary::open);
}

/// The last two conditions of the rule below, of a box for which the first two hold.
template <class Shadow, class AnyBox, class Margin, class HoldsOwnPiece>
[[nodiscard]] bool is_cull(const Shadow& shadow, const AnyBox& box, const Margin& margin,
                           const HoldsOwnPiece& holds_own_piece) {
  return margin.keeps(shadow, box) && !holds_own_piece();
}

/// The rule. A box may be culled by a shadow, and the answer is `inside`, if and only if
///  - the whole box is inside the shadow,
///  - it is strictly beyond the near plane, because what is coplanar with an occluder is drawn,
///  - both hold with the margin as well, for renderers that round (a ShadowMargin or a ShrunkShadow), and
///  - holds_own_piece() says that no part of the occluder is in the box. An occluder never hides itself, and the faces of a
///   shell that are turned away from the eye are drawn with the others.
/// If only one of the last two fails, the answer is `partial`, because what is below may still be culled.
template <class Shadow, class AnyBox, class Margin, class HoldsOwnPiece>
[[nodiscard]] kernel::Decision decide_cull(const Shadow& shadow, const AnyBox& box, const Asked& asked, const Margin& margin,
                                           const HoldsOwnPiece& holds_own_piece) {
  kernel::Decision found = decide_open(shadow, box, asked);
  if (found.relation == kernel::Relation::inside && !is_cull(shadow, box, margin, holds_own_piece)) {
    found.relation = kernel::Relation::partial;
  }
  return found;
}

/// The same for a box that holds no part of any occluder.
template <class Shadow, class AnyBox>
[[nodiscard]] kernel::Decision decide_cull(const Shadow& shadow, const AnyBox& box, const Asked& asked,
                                           const ShadowMargin& margin) {
  return decide_cull(shadow, box, asked, margin, [] { return false; });
}

}  // namespace occlude::culler
