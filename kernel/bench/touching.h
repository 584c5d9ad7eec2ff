// SPDX-License-Identifier: MIT
// Boxes that touch the border of a shadow frustum.
#pragma once

#include "occlude/fuzz/random.h"
#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/types.h"

namespace occlude::bench {

/// The numbers of a touching box. `whole`: they are whole where the eye, the corners and quarters of the edges of the near
/// face are, and the box touches exactly. `real`: any numbers, and the box touches up to rounding.
enum class Numbers { whole, real };

/// A box that touches a plane, an edge or a vertex of the frustum, from inside or outside. REQUIRES: the frustum has four
/// sides, and its silhouette bounds the near face.
[[nodiscard]] kernel::Aabb touching_box(const kernel::ShadowFrustum& frustum, Numbers numbers, fuzz::Random& random);

/// The box with each of its coordinates moved by -2 to 2 ulps, still with min <= max.
[[nodiscard]] kernel::Aabb nudged(const kernel::Aabb& box, fuzz::Random& random);

}  // namespace occlude::bench
