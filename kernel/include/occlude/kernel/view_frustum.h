// SPDX-License-Identifier: MIT
// A box against a view frustum: any intersection of half-spaces, with a far plane or without. Reading order: 12.
#pragma once

#include <span>

#include "occlude/kernel/half_space.h"
#include "occlude/kernel/overlap.h"
#include "occlude/kernel/types.h"

namespace occlude::kernel {

/// Exact relation of `box` to the intersection of the half-spaces, in any order, redundant ones included; touching is
/// `partial` unless the box is inside. Cubic in their number, which is five or six for a view frustum.
/// No half-space at all leaves all of space, which every box is inside. REQUIRES: coefficients within the legal range
/// (validity.h), check(box) == Refusal::none, which are not checked, rounding to nearest, and an intersection that is not
/// empty: of an empty one nothing but `inside` is sure to be right.
[[nodiscard]] Decision overlap_certified(std::span<const HalfSpace> frustum, const Aabb& box);
[[nodiscard]] Decision overlap_certified(std::span<const HalfSpace> frustum, const Obb& box);

}  // namespace occlude::kernel
