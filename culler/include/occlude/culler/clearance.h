// SPDX-License-Identifier: MIT
// By how much a cull is one: distances of boxes from the planes that decide. Reading order: 14.
#pragma once

#include <cstddef>

#include "occlude/culler/box.h"
#include "occlude/culler/camera.h"
#include "occlude/kernel/shadow_frustum.h"

namespace occlude::culler {

/// How far a box is on the inner side of all the planes of a shadow: units of the scene.
struct Clearance {
  double distance = 0;    ///< up to rounding; negative: how far a corner sticks out
  double at_least = 0;    ///< where positive, no more than the real number, whatever was rounded
  std::size_t plane = 0;  ///< the nearest: those of the near side first, then one for each edge of the silhouette
};

[[nodiscard]] Clearance clearance(const kernel::ShadowFrustum& shadow, const kernel::Aabb& box);
[[nodiscard]] Clearance clearance(const kernel::ShadowFrustum& shadow, const kernel::Obb& box);

/// How far all of the box is beyond the half-space, where positive no more than the real number; negative where a corner is
/// in it.
[[nodiscard]] double distance_beyond(const HalfSpace& half_space, const kernel::Aabb& box);
[[nodiscard]] double distance_beyond(const HalfSpace& half_space, const kernel::Obb& box);

}  // namespace occlude::culler
