// SPDX-License-Identifier: MIT
// A box against a half-space with given coefficients: the plane of a view frustum. Reading order: 12.
#pragma once

#include "occlude/kernel/types.h"

namespace occlude::kernel {

/// {x : normal . x + offset >= 0}, the coefficients taken as exact numbers within the legal range (validity.h).
struct HalfSpace {
  Vec3 normal;
  double offset = 0;
};

/// `inside` when all of the box is in the half-space, `outside` when none of it is; exact for `certified`. REQUIRES:
/// coefficients within the legal range, check(box) == Refusal::none, which are not checked, and rounding to nearest.
[[nodiscard]] Relation relation(const HalfSpace& half_space, const Aabb& box, Arithmetic arithmetic);
[[nodiscard]] Relation relation(const HalfSpace& half_space, const Obb& box, Arithmetic arithmetic);

}  // namespace occlude::kernel
