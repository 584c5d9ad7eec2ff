// SPDX-License-Identifier: MIT
// Boxes as callers have them, made legal for the kernel.
#pragma once

#include <optional>

#include "occlude/culler/box.h"

namespace occlude::culler {

/// A legal box that holds the given one and whose outer_box() is legal; none if the box reaches beyond 2^100 and so has no
/// place. Throws std::invalid_argument for a box with a fault().
[[nodiscard]] std::optional<Box> legal_box(const Box& box);

}  // namespace occlude::culler
