// SPDX-License-Identifier: MIT
// Every constant of the floating-point filter under its derivation. Reading order: 3.
//
// Model: IEEE double, round to nearest, u = 2^-53. Without overflow or underflow fl(a op b) = (a op b)(1 + d), |d| <= u;
// a product of n such factors is 1 + t with |t| <= g(n) = n u / (1 - n u). With every magnitude 0 or in the legal range
// (validity.h) the smallest non-zero difference of coordinates is 2^-152 and the largest 2^101. All expressions are of
// degree at most six in those, so they and their 53-bit tails and error terms stay between 2^-1022 and 2^1023: nothing
// overflows and nothing underflows. Fused multiply-adds round less often than the model and in any order of summation every
// bound below holds: instruction sets and compilers may differ, answers do not.
//
// Nor does the scaling of stored planes by powers of two (rounded_plane.cpp). With axes that are the coordinate axes,
// normals are of degree at most three, multiples of 2^-456 up to 2^305, and offsets of four, of 2^-608 up to 2^408. A slope,
// at least u 2^-456 and less than 8 u (3 * 2^305), lies in [2^-509, 2^257). Scaled, normals stay below 2^51 and offsets
// below 2^917; what they are multiples of, and the products with coordinates, 2^-865 or more; error terms, even where they
// come from errors of two factors alone, u^2 2^-608, 2^-971.
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
/// less than a factor 1 - 6 u: multiplying by this factor, 1 + 8 u, itself rounded once, makes up for it. Nobody will see a
/// test fail without the 8 u: for that an error would have to come within 6 u of its bound, all roundings at their worst at
/// once.
inline constexpr double kBoundInflation = 1 + 0x1p-50;

/// Plane value f(x) = N . y + o over a box, y = x - origin: evaluated as fl(n . c + w) at the centre and fl(sum_k |n_k| h_k)
/// for what it gains from there to a vertex, and their sum or difference, with coefficients n, w that are off by at most e_k
/// in component k and by e_w. Of an axis-aligned box c and h are half the sum and half the difference of
/// fl(min - origin) and fl(max - origin); to leave the halves out and double w rounds nothing else and doubles all.
///
///   c_k, h_k              two roundings each: t2
///   n_k c_k, |n_k| h_k    one more: t3
///   n . c + w             products up to three additions: t6; w up to three: t3
///   sum_k |n_k| h_k       products up to two additions: t5
///   both together         one addition: t7 of n_k c_k, t6 of |n_k| h_k, t4 of w
///
/// so the value is off by at most g(7) sum_k |n_k| (|c_k| + h_k) + g(4) |w| + sum_k e_k (|c_k| + h_k) + e_w
///                             <= (g(7) sum_k |n_k| + sum_k e_k) reach + (g(4) |w| + e_w)
/// with reach = max_k (|c_k| + h_k), which is slope * reach + base. An oriented box has its centre given, c_k t1, and the
/// spread sum_j |n . h_j| of half edges given: products t1, two additions t3, two among the three t5, the last t6: the same
/// bound holds with reach = max_k |c_k| + sum_j max_k |h_j,k|. The second order in g, and reach computed with at most three
/// roundings, are less than 2^-45 of the whole:
inline constexpr double kPlaneError = (7 + 0x1p-40) * kUnitRoundoff;
inline constexpr double kOffsetError = (4 + 0x1p-40) * kUnitRoundoff;

/// Value of a refined plane, n + m in place of n, w + v in place of w, with |m| <= u |n| and |v| <= u |w|: products n_k y_k
/// and their sums with w by error-free transformations; what these lose, n_k times the tail of y_k, m_k y_k and v, 13 terms
/// in all, in doubles. With S = sum_k |n_k y_k| + |w| those terms sum to less than 8 u S: three partial sums lose 3 u S, the
/// other ten terms at most 4 u S together. Adding them up in any order errs by less than 13 u times that, and m_k times the
/// tail of y_k, u^2 S, is left out: 105 u^2 S in all. The constant is rounded up to a power of two. That slack, and any
/// other here, is of no account: what doubles leave within 2^-99 S of zero is zero in all but contrived cases, and no bound
/// could tell it.
inline constexpr double kRefinedError = 0x1p7 * kUnitRoundoff * kUnitRoundoff;

/// Half-space value g(x) = n_x x + n_y y + n_z z + d with coefficients and coordinates given: products t1, two additions t3,
/// so the sum s of the products is off by at most g(3) sum_k |n_k x_k|. The last addition, of d, rounds without a change of
/// sign: that of fl(s + d) is that of g when it exceeds the bound. The sum of magnitudes is computed with at most g(3) loss,
/// the product with the constant loses one more u: any c >= 3 (1 + 2^-48) is sound.
inline constexpr double kHalfSpaceError = (3 + 0x1p-40) * kUnitRoundoff;

}  // namespace occlude::kernel
