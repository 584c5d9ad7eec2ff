// SPDX-License-Identifier: MIT
// Points in oriented boxes, for code that fits such boxes. Reading order: 14.
#pragma once

#include "occlude/kernel/types.h"

namespace occlude::kernel {

/// Whether the point lies in the box or on its surface, exactly. Exception: always false if the half edges are linearly
/// dependent, so that the box is flat. REQUIRES (not checked): check(box) == Refusal::none, check(point) == Refusal::none,
/// and rounding to nearest (validity.h).
[[nodiscard]] bool contains(const Obb& box, const Vec3& point);

}  // namespace occlude::kernel
