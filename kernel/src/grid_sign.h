// SPDX-License-Identifier: MIT
// Exact signs of planes by integers of fixed width: a step of the exact stage. Doubles are multiples of a power of two, and
// those of one model are multiples of one that is not much smaller than they are, such as decimal numbers of a few digits.
#pragma once

#include <optional>

#include "occlude/kernel/types.h"
#include "planes.h"

namespace occlude::kernel {

/// Exact sign of the plane at x: 1 on the inner side, 0 on the plane, -1 on the outer side. None if the coordinates are not
/// multiples of one power of two by factors of at most 119 bits. REQUIRES: legal numbers, or the sign means nothing.
[[nodiscard]] std::optional<int> grid_sign(const ExactPlane& plane, const Vec3& x);

/// The same at the extremal vertex of the box along the normal: the nearest (`direction` = -1) or the farthest (1).
[[nodiscard]] std::optional<int> grid_extremal_sign(const ExactPlane& plane, const Aabb& box, int direction);

}  // namespace occlude::kernel
