// SPDX-License-Identifier: MIT
// Boxes that touch the border of a shadow frustum.
#pragma once

#include <cstddef>

#include "occlude/fuzz/random.h"
#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/types.h"

namespace occlude::bench {

/// Which numbers a touching box is made of. `whole`: whole ones where eye, corners and quarters of the near face's edges are
/// whole, so that it touches exactly. `real`: any, so that it touches up to rounding.
enum class Numbers { whole, real };

/// A box that touches a plane, an edge or a vertex of the frustum, from inside or outside. REQUIRES: four sides, and the
/// silhouette bounds the near face.
[[nodiscard]] kernel::Aabb touching_box(const kernel::ShadowFrustum& frustum, Numbers numbers, fuzz::Random& random);

/// The box with each of its coordinates moved by -2 to 2 ulps, and still min <= max.
[[nodiscard]] kernel::Aabb nudged(const kernel::Aabb& box, fuzz::Random& random);

}  // namespace occlude::bench
