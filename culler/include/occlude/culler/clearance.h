// SPDX-License-Identifier: MIT
// How far boxes are beyond planes of the view; how far they are within shadows says occlude/kernel/clearance.h. Reading
// order: 14.
#pragma once

#include "occlude/culler/box.h"
#include "occlude/culler/camera.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// How far all of the box is beyond the half-space, where positive no more than the real number; negative where a corner is
/// in it.
[[nodiscard]] double distance_beyond(const HalfSpace& half_space, const kernel::Aabb& box);
[[nodiscard]] double distance_beyond(const HalfSpace& half_space, const kernel::Obb& box);

}  // namespace occlude::culler
