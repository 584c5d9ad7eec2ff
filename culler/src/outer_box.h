// SPDX-License-Identifier: MIT
// The axis-aligned box around any box, and which boxes can have one.
#pragma once

#include "occlude/culler/box.h"
#include "occlude/kernel/types.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {

/// An axis-aligned box that holds every point of the box, exactly. For an axis-aligned box it is the box itself; for an
/// oriented box it is a few ulps wider than necessary. REQUIRES: kernel::check of the box is none.
[[nodiscard]] kernel::Aabb outer_box(const Box& box);

/// Why the box cannot be in a tree: the kernel refuses the box, or the axis-aligned box around it.
[[nodiscard]] kernel::Refusal refusal_of(const Box& box);

}  // namespace occlude::culler
