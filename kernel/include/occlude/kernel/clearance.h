// SPDX-License-Identifier: MIT
// How far a box is from the planes of a shadow frustum, in the units of the input.
#pragma once

#include <cstddef>

#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/types.h"

namespace occlude::kernel {

/// The least signed distance of a box from the planes of a shadow, and the plane that has it.
struct Clearance {
  double distance = 0;    ///< rounded; negative: how far the box sticks out beyond `plane`
  std::size_t plane = 0;  ///< its number, less than ShadowFrustum::plane_count()
};

/// The clearance of the box, in doubles: not a proof. {-infinity, 0} if shadow.is_none(). REQUIRES, here and below (not
/// checked): check(box) == Refusal::none, and rounding to nearest (validity.h).
[[nodiscard]] Clearance clearance(const ShadowFrustum& shadow, const Aabb& box);
[[nodiscard]] Clearance clearance(const ShadowFrustum& shadow, const Obb& box);

/// A lower bound, whatever was rounded, on the distance of the box from every plane of the shadow. 0 unless the box is
/// certainly in the shadow and off all planes; 0 if shadow.is_none(). Costs one square root.
[[nodiscard]] double certain_distance(const ShadowFrustum& shadow, const Aabb& box);
[[nodiscard]] double certain_distance(const ShadowFrustum& shadow, const Obb& box);

}  // namespace occlude::kernel
