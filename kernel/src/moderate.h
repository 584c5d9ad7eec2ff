// SPDX-License-Identifier: MIT
// Expressions of degree nine: which numbers they are exact for in doubles, and the arithmetic for all others.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "arithmetic.h"
#include "big_integer.h"
#include "occlude/kernel/types.h"

namespace occlude::kernel {

/// Numbers of which products of nine factors, each a sum of up to five numbers, neither overflow nor underflow in doubles.
/// They are multiples of 2^-102 and their sums at most 2^60. The products and their sums are then multiples of 2^-918 below
/// 2^550: their error terms, which are a 2^-53rd of them, stay above 2^-1022, and an Expansion holds them in 29 terms.
inline constexpr double kLeastModerate = 0x1p-50, kGreatestModerate = 0x1p57;

[[nodiscard]] inline bool is_moderate(double x) {
  const double size = std::fabs(x);
  return size == 0 || (size >= kLeastModerate && size <= kGreatestModerate);
}
[[nodiscard]] inline bool is_moderate(const Vec3& v) { return is_moderate(v.x) && is_moderate(v.y) && is_moderate(v.z); }
[[nodiscard]] inline bool is_moderate(std::span<const Vec3> points) {
  return std::ranges::all_of(points, [](const Vec3& v) { return is_moderate(v); });
}
[[nodiscard]] inline bool is_moderate(const Aabb& box) { return is_moderate(box.min) && is_moderate(box.max); }
[[nodiscard]] inline bool is_moderate(const Obb& box) { return is_moderate(box.center) && is_moderate(box.half_edges); }

/// Integers of any size, in units of 2^-152, of which all legal numbers are multiples. For homogeneous expressions. Slow,
/// and allocates.
struct BigArithmetic {
  using Number = BigInteger;
  static BigInteger constant(double x) { return BigInteger::scaled(x, 152); }
  static BigInteger difference(double a, double b) { return constant(a) - constant(b); }
  static BigInteger magnitude(const BigInteger& x) { return x.sign() < 0 ? -x : x; }
  static int sign(const BigInteger& x) { return x.sign(); }
};

}  // namespace occlude::kernel
