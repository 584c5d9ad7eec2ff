// SPDX-License-Identifier: MIT
// A box against a half-space with given coefficients: the plane of a view frustum. Reading order: 12.
#pragma once

#include "occlude/kernel/types.h"

namespace occlude::kernel {

/// {x : normal . x + offset >= 0}. The coefficients are exact numbers within the legal range (validity.h); the normal need
/// not have length 1.
struct HalfSpace {
  Vec3 normal;
  double offset = 0;
};

/// `inside` if all of the box is in the half-space, `outside` if none of it is, else `partial`. Exact for `certified`;
/// `plain` may be wrong by rounding. Nothing is allocated. REQUIRES (not checked): legal coefficients, check(box) ==
/// Refusal::none, and rounding to nearest (validity.h).
[[nodiscard]] Relation relation(const HalfSpace& half_space, const Aabb& box, Arithmetic arithmetic);
[[nodiscard]] Relation relation(const HalfSpace& half_space, const Obb& box, Arithmetic arithmetic);

}  // namespace occlude::kernel
