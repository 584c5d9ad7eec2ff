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
  double distance = 0;    ///< up to rounding; negative: how far a corner sticks out, infinitely where there is no shadow
  std::size_t plane = 0;  ///< the nearest: those of the near side first, then one for each edge of the silhouette
};

[[nodiscard]] Clearance clearance(const kernel::ShadowFrustum& shadow, const kernel::Aabb& box);
[[nodiscard]] Clearance clearance(const kernel::ShadowFrustum& shadow, const kernel::Obb& box);

/// No more than the distance of the box, which is in the shadow, from any of the shadow's planes, whatever was rounded; 0
/// where no more is certain or there is no shadow (ShadowFrustum::is_none()). For every cull of a frame: takes one root.
[[nodiscard]] double certain_distance(const kernel::ShadowFrustum& shadow, const kernel::Aabb& box);
[[nodiscard]] double certain_distance(const kernel::ShadowFrustum& shadow, const kernel::Obb& box);

/// How far all of the box is beyond the half-space, where positive no more than the real number; negative where a corner is
/// in it.
[[nodiscard]] double distance_beyond(const HalfSpace& half_space, const kernel::Aabb& box);
[[nodiscard]] double distance_beyond(const HalfSpace& half_space, const kernel::Obb& box);

}  // namespace occlude::culler
