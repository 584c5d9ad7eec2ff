// SPDX-License-Identifier: MIT
// A point against a box, for those who fit boxes. Reading order: 14.
#pragma once

#include "occlude/kernel/types.h"

namespace occlude::kernel {

/// Whether the point lies in the box, its faces included: exact. Never in a box of dependent half edges, which is flat.
/// REQUIRES: check(box) == Refusal::none, check(point) == Refusal::none, which are not checked, and rounding to nearest
/// (validity.h).
[[nodiscard]] bool contains(const Obb& box, const Vec3& point);

}  // namespace occlude::kernel
