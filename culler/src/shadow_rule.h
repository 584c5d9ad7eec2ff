// SPDX-License-Identifier: MIT
// When a box may be culled by a shadow.
#pragma once

#include "occlude/culler/shadow_margin.h"
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

/// Of one shadow or of two together, which are always asked exactly; the near plane is open.
template <class AnyBox>
[[nodiscard]] kernel::Decision decide_open(const kernel::ShadowFrustum& shadow, const AnyBox& box, const Asked& asked) {
  return kernel::decide(shadow, box, asked.arithmetic, asked.test, kernel::NearBoundary::open);
}
template <class AnyBox>
[[nodiscard]] kernel::Decision decide_open(const kernel::ShadowUnion& shadows, const AnyBox& box, const Asked&) {
  return kernel::overlap_certified(shadows, box, kernel::NearBoundary::open);
}

/// The rule. A box may be culled by a shadow, and `inside` is the answer, if and only if
///  - all of it is inside of the shadow,
///  - strictly beyond the near plane: what is coplanar with an occluder is drawn,
///  - it is so with the margin as well, for renderers that round, and
///  - holds_own_piece() says that nothing is in it of what the occluder is drawn as: no occluder hides itself, and the faces
///    of a shell that the eye does not see are drawn with the others.
/// Where one of the last two fails, what is below may still be culled: `partial`.
template <class Shadow, class AnyBox, class HoldsOwnPiece>
[[nodiscard]] kernel::Decision decide_cull(const Shadow& shadow, const AnyBox& box, const Asked& asked,
                                           const ShadowMargin& margin, const HoldsOwnPiece& holds_own_piece) {
  kernel::Decision found = decide_open(shadow, box, asked);
  if (found.relation == kernel::Relation::inside && (!margin.keeps(shadow, box) || holds_own_piece())) {
    found.relation = kernel::Relation::partial;
  }
  return found;
}

/// The same of what is no part of any occluder.
template <class Shadow, class AnyBox>
[[nodiscard]] kernel::Decision decide_cull(const Shadow& shadow, const AnyBox& box, const Asked& asked,
                                           const ShadowMargin& margin) {
  return decide_cull(shadow, box, asked, margin, [] { return false; });
}

}  // namespace occlude::culler
