// SPDX-License-Identifier: MIT
// How far boxes are beyond planes of the view. For how far they are inside shadows see occlude/kernel/clearance.h. Reading
// order: 14.
#pragma once

#include "occlude/culler/box.h"
#include "occlude/culler/camera.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// A lower bound on the distance from the half-space to the box, in model units.
/// 1. If it is positive, the whole box is outside the half-space, at least that far from its plane.
/// 2. If a corner of the box is in the half-space, it is not positive. It may also be negative for a box just outside.
/// REQUIRES: the box is legal; half_space.normal != 0. Neither is checked.
[[nodiscard]] double distance_beyond(const HalfSpace& half_space, const kernel::Aabb& box);
[[nodiscard]] double distance_beyond(const HalfSpace& half_space, const kernel::Obb& box);

}  // namespace occlude::culler
