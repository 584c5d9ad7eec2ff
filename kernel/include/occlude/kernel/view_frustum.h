// SPDX-License-Identifier: MIT
// A box against a view frustum: any intersection of half-spaces, with or without a far plane. Reading order: 12.
#pragma once

#include <span>

#include "occlude/kernel/half_space.h"
#include "occlude/kernel/overlap.h"
#include "occlude/kernel/types.h"

namespace occlude::kernel {

/// The exact relation of `box` to the intersection of the half-spaces.
/// 1. A box that only touches the intersection is `partial`, or `inside` if all of it lies in the border.
/// 2. Order and redundant half-spaces do not matter. With no half-space every box is `inside`.
/// 3. If the intersection is empty, the answer is `outside` or, wrongly, `partial`; never `inside`.
/// 4. Time is cubic in the number of half-spaces, which is five or six for a view frustum. Nothing is allocated.
/// REQUIRES (not checked): legal coefficients, check(box) == Refusal::none, and rounding to nearest (validity.h).
[[nodiscard]] Decision overlap_certified(std::span<const HalfSpace> frustum, const Aabb& box);
[[nodiscard]] Decision overlap_certified(std::span<const HalfSpace> frustum, const Obb& box);

}  // namespace occlude::kernel
