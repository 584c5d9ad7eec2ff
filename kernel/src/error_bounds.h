// SPDX-License-Identifier: MIT
// Every constant of the floating-point filter under its derivation. Reading order: 3.
//
// Model: IEEE double, round to nearest, u = 2^-53. Without overflow or underflow fl(a op b) = (a op b)(1 + d), |d| <= u;
// a product of n such factors is 1 + t with |t| <= g(n) = n u / (1 - n u). With every magnitude 0 or in the legal range
// (validity.h) the smallest non-zero difference of coordinates is 2^-152 and the largest 2^101. All expressions are of
// degree at most six in those, so they and their 53-bit tails and error terms stay between 2^-1022 and 2^1023: nothing
// overflows and nothing underflows. Fused multiply-adds round less often than the model and in any order of summation every
// bound below holds: instruction sets and compilers may differ, answers do not.
#pragma once

#ifdef __FAST_MATH__
#error "the kernel is exact only in IEEE arithmetic: compile it without -ffast-math"
#endif

#include <cfloat>
#include <limits>

namespace occlude::kernel {

static_assert(std::numeric_limits<double>::is_iec559 && FLT_EVAL_METHOD == 0, "the bounds below assume plain IEEE doubles");

inline constexpr double kUnitRoundoff = 0x1p-53;

/// Bounds are themselves computed in doubles, each from at most six rounded operations on non-negative numbers, which lose
/// less than a factor 1 - 6 u: multiplying by this factor, 1 + 8 u, itself rounded once, makes up for it.
inline constexpr double kBoundInflation = 1 + 0x1p-50;

/// Plane value f(x) = N . y + o, y = x - origin, evaluated as fl(n . fl(y) + w) with coefficients n, w that are off by at
/// most e_k in component k and by e_w.
///
///   y_k                       one rounding: t1
///   n_k y_k                   t1 and its own: t2;  up to three additions: t5
///   w                         up to three additions: t3
///
/// so |fl(f) - f| <= g(5) sum_k |n_k y_k| + g(3) |w| + sum_k e_k |y_k| + e_w
///                <= (g(5) sum_k |n_k| + sum_k e_k) max_k |y_k| + (g(3) |w| + e_w),
/// which is slope * reach + base. Reach is the largest |fl(y_k)|, within a factor 1 + 2 u of the largest |y_k|; this and the
/// second order in g are less than 2^-45 of the whole:
inline constexpr double kPlaneError = (5 + 0x1p-40) * kUnitRoundoff;
inline constexpr double kOffsetError = (3 + 0x1p-40) * kUnitRoundoff;

/// An oriented box adds to the value at its centre the spread sum_k |n . h_k|: products t1 and two additions t3, two
/// additions among the three t5, one to the value at the centre t6, which raises that one's t5 to t6 and t3 to t4. With
/// reach = max_k |c_k| + sum_j max_k |h_j,k| the bound above holds times max(6 / 5, 4 / 3):
inline constexpr double kSpreadInflation = 4.0 / 3 * (1 + 0x1p-40);

/// A box given by twice its centre c and its extent h, both found from its bounds relative to the origin: c_k and h_k t2,
/// products t3, c and w into one sum t6 and t3, h into another t5, one more addition of the two t7 and t4. As |c_k| + h_k is
/// twice the larger of the magnitudes of the bounds, the bound above holds for half the value times max(7 / 5, 4 / 3):
inline constexpr double kCentredInflation = 7.0 / 5 * (1 + 0x1p-40);

/// Value of a refined plane, n + m in place of n, w + v in place of w, with |m| <= u |n| and |v| <= u |w|: products n_k y_k
/// and their sums with w by error-free transformations; what these lose, n_k times the tail of y_k, m_k y_k and v, 13 terms
/// in all, in doubles. With S = sum_k |n_k y_k| + |w| those terms sum to less than 8 u S: three partial sums lose 3 u S, the
/// other ten terms at most 4 u S together. Adding them up in any order errs by less than 13 u times that, and m_k times the
/// tail of y_k, u^2 S, is left out: 105 u^2 S in all. The constant is rounded up to a power of two. That slack, and any
/// other here, is of no account: what doubles leave within 2^-99 S of zero is zero in all but contrived cases, and no bound
/// could tell it.
inline constexpr double kRefinedError = 0x1p7 * kUnitRoundoff * kUnitRoundoff;

/// Half-space value g(x) = n_x x + n_y y + n_z z + d with coefficients and coordinates given: products t1, three additions
/// t4 in all, so |fl(g) - g| <= g(4) (sum_k |n_k x_k| + |d|). The sum is computed with at most g(4) loss, the product with
/// the constant loses one more u: any c >= 4 (1 + 2^-48) is sound.
inline constexpr double kHalfSpaceError = (4 + 0x1p-40) * kUnitRoundoff;

}  // namespace occlude::kernel
