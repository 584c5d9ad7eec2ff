// SPDX-License-Identifier: MIT
// What is seen from anywhere in a box of eyes, in all directions.
#pragma once

#include <functional>

#include "occlude/culler/culler.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// A camera in the middle of a box, with a region of eyes that holds all of the box, however its numbers round.
/// REQUIRES: kernel::check() refuses nothing of the box.
[[nodiscard]] Camera camera_of(const kernel::Aabb& eyes);

/// Culls six frames for all eyes of a box and calls take() after each, whose result is view.result().
/// 1. From nowhere in the box does a segment reach anything, in any direction, that all six frames cull: it meets an opaque
///    polygon strictly between. Nothing is before a near plane.
/// 2. So it is of any other box that none of the frames shows (View::visibility), and of a polygon if each frame that does
///    not cull it does not show its box.
/// Throws as Culler::cull(), and what take() throws. REQUIRES: kernel::check() refuses nothing of the box.
void cull_around(const Culler& culler, const kernel::Aabb& eyes, const CullOptions& options, View& view,
                 const std::function<void()>& take);

}  // namespace occlude::culler
