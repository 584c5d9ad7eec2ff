// SPDX-License-Identifier: MIT
// The axis-aligned box around any box, and which boxes it can be drawn around.
#pragma once

#include "occlude/culler/box.h"
#include "occlude/kernel/types.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {

/// Holds every point of the box, exactly. An axis-aligned box is its own; that of an oriented one is wider than it need be
/// by a few ulps. REQUIRES: kernel::check of the box is none.
[[nodiscard]] kernel::Aabb outer_box(const Box& box);

/// Why the box cannot be in a tree: the kernel does not take it, or not the box around it.
[[nodiscard]] kernel::Refusal refusal_of(const Box& box);

}  // namespace occlude::culler
