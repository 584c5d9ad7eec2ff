// SPDX-License-Identifier: MIT
// Every constant of the floating-point filter under its derivation. Reading order: 3.
//
// Model: IEEE double, round to nearest, u = 2^-53. Without overflow or underflow fl(a op b) = (a op b)(1 + d), |d| <= u;
// a product of n such factors is 1 + t with |t| <= g(n) = n u / (1 - n u). The legal range (validity.h) excludes overflow
// and underflow from every expression here: all are of degree at most six in coordinate differences.
#pragma once

#ifdef __FAST_MATH__
#error "the kernel is exact only in IEEE arithmetic: compile it without -ffast-math"
#endif

#include <cfloat>
#include <limits>

namespace occlude::kernel {

static_assert(std::numeric_limits<double>::is_iec559 && FLT_EVAL_METHOD == 0, "the bounds below assume plain IEEE doubles");

inline constexpr double kUnitRoundoff = 0x1p-53;

/// Plane value f(x) = N . (x - r) with N = a cross b, where a, b and x - r are differences of two coordinates each.
///
///   a, b, x - r        one rounding each: factor 1 + t1
///   a_j b_k            t1 t1 and its own rounding: t3;     the difference of two such: t4, of a_j b_k and a_k b_j alike
///   N_k (x - r)_k      t4, t1 and its own rounding: t6;    two additions: t8
///
/// so |fl(f) - f| <= g(8) sum_k P_k |x - r|_k with P_k = |a_j b_k| + |a_k b_j|. A normal given by a single difference or by
/// its coordinates has fewer roundings and P_k = |N_k|; the same constant covers it.
///
/// The bound is computed as c * u * (P_x + P_y + P_z) * max_k |x - r|_k in doubles. That computation loses at most a factor
/// g(11): t4 in each P_k, two additions, t1 in |x - r|, the products with c u (u is a power of two: exact; c: one), with the
/// sum and with the maximum: three. g(8) (1 + g(11)) < 8 u (1 + 2^-48), hence any c >= 8 (1 + 2^-48) is sound:
inline constexpr double kPlaneError = (8 + 0x1p-40) * kUnitRoundoff;

/// Half-space value g(x) = n_x x + n_y y + n_z z + d with coefficients and coordinates given: products t1, three additions
/// t4 in all, so |fl(g) - g| <= g(4) (sum_k |n_k x_k| + |d|). The sum is computed with at most g(4) loss, the product with
/// the constant loses one more u: any c >= 4 (1 + 2^-48) is sound.
inline constexpr double kHalfSpaceError = (4 + 0x1p-40) * kUnitRoundoff;

/// Running error analysis (running_error.h) adds up at most six rounded operations on non-negative numbers for each bound,
/// which lose less than a factor 1 - 6 u: multiplying by this factor, 1 + 8 u, itself rounded once, makes up for it.
inline constexpr double kRunningErrorInflation = 1 + 0x1p-50;

}  // namespace occlude::kernel
