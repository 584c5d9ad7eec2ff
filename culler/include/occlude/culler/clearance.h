// SPDX-License-Identifier: MIT
// By how much a cull is one: distances of boxes from the planes that decide. Reading order: 14.
#pragma once

#include <cstddef>

#include "occlude/culler/box.h"
#include "occlude/culler/camera.h"
#include "occlude/kernel/shadow_frustum.h"

namespace occlude::culler {

/// Of all the planes of a shadow the one that a box is least on the inner side of.
struct Clearance {
  double distance = 0;    ///< units of the scene, up to rounding: positive inside; negative, how far a corner sticks out
  std::size_t plane = 0;  ///< its number: those of the near side first, then one for each edge of the silhouette
};

[[nodiscard]] Clearance clearance(const kernel::ShadowFrustum& shadow, const Box& box);

/// How far all of the box is beyond the half-space; negative where a corner is in it.
[[nodiscard]] double distance_beyond(const HalfSpace& half_space, const Box& box);

}  // namespace occlude::culler
