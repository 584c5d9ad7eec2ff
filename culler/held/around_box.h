// SPDX-License-Identifier: MIT
// Cameras whose eye may be anywhere in a box.
#pragma once

#include <array>

#include "occlude/culler/camera.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// A camera in the middle of a box, with a region of eyes that holds all of the box, however its numbers round.
/// REQUIRES: kernel::check() refuses nothing of the box.
[[nodiscard]] Camera camera_of(const kernel::Aabb& eyes);

/// Six such cameras whose pictures hold all directions. No frame of them culls anything because it is before a near plane.
/// REQUIRES: as camera_of().
[[nodiscard]] std::array<Camera, 6> cameras_around(const kernel::Aabb& eyes);

}  // namespace occlude::culler
