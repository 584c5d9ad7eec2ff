// SPDX-License-Identifier: MIT
// How far a box is from the planes of a shadow frustum.
#pragma once

#include <cstddef>

#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/types.h"

namespace occlude::kernel {

/// How far a box is on the inner side of all the planes of a shadow: units of the input.
struct Clearance {
  double distance = 0;    ///< up to rounding; negative: how far a corner sticks out, infinitely where there is no shadow
  std::size_t plane = 0;  ///< the nearest: those of the near side first, then one for each edge of the silhouette
};

/// REQUIRES, here and below: check(box) == Refusal::none, which is not checked, and rounding to nearest (validity.h).
[[nodiscard]] Clearance clearance(const ShadowFrustum& shadow, const Aabb& box);
[[nodiscard]] Clearance clearance(const ShadowFrustum& shadow, const Obb& box);

/// No more than the distance of the box, which is in the shadow, from any of the shadow's planes, whatever was rounded; 0
/// where no more is certain or there is no shadow (ShadowFrustum::is_none()). Takes one root.
[[nodiscard]] double certain_distance(const ShadowFrustum& shadow, const Aabb& box);
[[nodiscard]] double certain_distance(const ShadowFrustum& shadow, const Obb& box);

}  // namespace occlude::kernel
