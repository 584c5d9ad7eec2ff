// SPDX-License-Identifier: MIT
// On which side of a plane or a line a point lies, for code that fits boxes into solids. Reading order: 14.
#pragma once

#include "occlude/kernel/types.h"

namespace occlude::kernel {

/// The sign of det(b - a, c - a, d - a), exactly: 1 if a, b, c turn counter-clockwise seen from d, -1 if clockwise, 0 if all
/// four lie in a plane. REQUIRES, here and below (not checked): legal points, and rounding to nearest (validity.h).
[[nodiscard]] int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The sign of coordinate `axis` of (b - a) x (c - a), exactly: 1 if a, b, c turn counter-clockwise for who looks against
/// this axis, -1 if clockwise, 0 if they are collinear for him. REQUIRES: 0 <= axis <= 2.
[[nodiscard]] int turn(int axis, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace occlude::kernel
