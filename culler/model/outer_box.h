// SPDX-License-Identifier: MIT
// The axis-aligned box around any box.
#pragma once

#include "occlude/culler/box.h"
#include "occlude/kernel/types.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {

/// An axis-aligned box that holds every point of the box, exactly. For an axis-aligned legal box it is the box itself; for
/// an oriented box it is a few ulps wider than necessary. Its numbers are 0 or at least 2^-100. REQUIRES: finite numbers of
/// at most 2^100.
[[nodiscard]] kernel::Aabb outer_box(const Box& box);

}  // namespace occlude::culler
