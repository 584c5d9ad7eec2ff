// SPDX-License-Identifier: MIT
// Every constant of the floating-point filter under its derivation. Reading order: 3.
//
// Model: IEEE double, round to nearest, u = 2^-53. Without overflow or underflow fl(a op b) = (a op b)(1 + d), |d| <= u; a
// product of n such factors is 1 + t with |t| <= g(n) = n u / (1 - n u). With every magnitude 0 or in the legal range
// (validity.h) the smallest non-zero difference of coordinates is 2^-152 and the largest 2^101. All expressions are of
// degree at most six in those, so they and their 53-bit tails and error terms stay between 2^-1022 and 2^1023: nothing
// overflows and nothing underflows. A corner of a region of viewpoints is a sum of four numbers, so that a difference to it
// is below 2^103; no expression has more than four such factors. moderate.h is about the few expressions of a higher degree.
// Fused multiply-adds round less often than the model, and every bound below holds in any
// order of summation. So instruction sets and compilers may differ, but answers do not.
//
// The scaling of stored planes by powers of two (rounded_plane.cpp) does not overflow or underflow either. With axes that
// are the coordinate axes, normals are of degree at most three, multiples of 2^-456 up to 2^305, and offsets of four, of
// 2^-608 up to 2^408. A slope is at least u 2^-456 and less than 8 u (3 * 2^305), so it lies in [2^-509, 2^257). After
// scaling, normals stay below 2^51 and offsets below 2^917. The powers of two of which these are multiples stay at 2^-865 or
// more, and so do the products with coordinates. Error terms stay at 2^-971 or more, even those that come from the errors of
// two factors alone, which are at least u^2 2^-608 before scaling.
#pragma once

#if defined(__FAST_MATH__) || defined(_M_FP_FAST) || defined(_M_FP_CONTRACT)
#error "the kernel is exact only in IEEE arithmetic: compile it without -ffast-math"
#endif

#include <cfloat>
#include <limits>

namespace occlude::kernel {

static_assert(std::numeric_limits<double>::is_iec559 && FLT_EVAL_METHOD == 0, "the bounds below assume plain IEEE doubles");

inline constexpr double kUnitRoundoff = 0x1p-53;

/// The constants follow from counting successive roundings. The change that n of them make, as a share of the value after m
/// more, is at most g(n) / (1 - u)^m <= n u / (1 - (n + m) u) <= n u (1 + 2 (n + m) u). For n + m <= 100 the last factor,
/// and the rounding of the next line itself, are below 1 + 2^-44.
constexpr double rounding_error(int n) { return n * kUnitRoundoff * (1 + 0x1p-44); }

/// Bounds are themselves computed in doubles, by rounded operations on numbers that are not negative. Each term of a bound
/// loses at most a factor 1 - u per rounding on its way to the comparison of a value with the bound. This factor makes up
/// for n of them when (1 + 16 u) (1 - u)^n >= 1, where the n include the rounding of the product with the factor itself;
/// this holds when 16 u >= g(n).
inline constexpr double kBoundInflation = 1 + 16 * kUnitRoundoff;

/// The places where bounds are computed.
enum class BoundOf { running_sum, running_product, slope, base, refined_value };

/// The largest number of roundings that a term of such a bound passes through. Operations that happen to be exact are
/// counted as well: products with u, doubling, halving.
constexpr int roundings(BoundOf bound) {
  switch (bound) {
    // running_error.h, the term u |value|: the value itself, the product with u, the sum with the inherited errors;
    // inflation. One more where underflow is allowed for (certain_sign.h).
    case BoundOf::running_sum:
      return 1 + 1 + 1 + 1 + 1;
    // The term |a| b.error: the product, two sums with terms of the same kind, the sum with u |value|; inflation; the same
    // one more.
    case BoundOf::running_product:
      return 1 + 2 + 1 + 1 + 1;
    // rounded_plane.h: the uncertainty of a component, |low| + error; the sum of three; the sum with kPlaneError times the
    // magnitudes; inflation. Then, in the frame of a box, the product with the reach and the sum with the base. The largest
    // number of roundings is in the reach of an oriented box, whose centre is rounded once and takes three additions. The
    // reach of an axis-aligned box takes three roundings: a bound relative to the origin, the sum or difference of two, the
    // sum of these.
    case BoundOf::slope:
      return 1 + 2 + 1 + 1 + (1 + 3) + 1 + 1;
    // The uncertainty of the offset; the sum with kOffsetError times the offset; inflation; doubling; the sum with the
    // slope.
    case BoundOf::base:
      return 1 + 1 + 1 + 1 + 1;
    // rounded_plane.h: the sum of the components' uncertainties; the reach of an axis-aligned box, halved, and the product
    // with it; the sum with the base; inflation; the sum with kRefinedError times the magnitude.
    case BoundOf::refined_value:
      return 2 + (3 + 1) + 1 + 1 + 1 + 1;
  }
  return 0;
}

/// The bound, enlarged to make up for what its computation loses.
template <BoundOf of, class Real>
[[nodiscard]] Real inflated(const Real& bound) {
  static_assert(kBoundInflation - 1 >= rounding_error(roundings(of)));
  return bound * kBoundInflation;
}

/// Plane value f(x) = N . y + o over a box, y = x - origin, evaluated with coefficients n, w that are off by at most e_k in
/// component k and by e_w. The largest value over an axis-aligned box is that at the vertex with y_k = max_k - origin_k
/// where n_k >= 0, and min_k - origin_k elsewhere; the least is that at the opposite vertex. They are computed as
/// fl(n . c + w) at the centre, plus or minus fl(sum_k |n_k| h_k), where c and h are half the sum and half the difference of
/// fl(min - origin) and fl(max - origin). The code leaves the halves out and doubles w: this doubles all values and changes
/// no rounding.
///
///   fl(min - origin), fl(max - origin)   one rounding, in the exact value at the vertex a factor of y_k
///   c_k, h_k from these                  one more each, of their own
///   n_k c_k, |n_k| h_k                   one more
///   n . c + w                            three additions at most, in whatever order: of products and of w
///   sum_k |n_k| h_k                      two additions at most
///   both together                        one addition
///
/// Where min and max lie on either side of the origin, c_k by itself can be off by far more than two roundings of it. But
/// c_k and h_k share the roundings of min and max, and together they make a vertex. With R = max_k (|c_k| + h_k), which is
/// the largest |y_k| of a vertex, the first rounding costs at most u sum_k |n_k| R. Those that follow, six of n_k c_k and
/// five of |n_k| h_k, cost at most g(6) sum_k |n_k| (|c_k| + h_k). Together this is g(7) sum_k |n_k| R. On w there are three
/// additions and the last: g(4) |w|. So the value is off by at most
///   (g(7) sum_k |n_k| + sum_k e_k) R + (g(4) |w| + e_w) = slope * R + base.
/// For an oriented box the centre and the half edges h_j are given. On n_k c_k there are one rounding of c_k, the product,
/// three additions and the last. On n_k h_j,k there are the product, two additions within n . h_j, two among the three
/// |n . h_j| and the last. That is six at most. The same bound holds with R = max_k |c_k| + sum_j max_k |h_j,k|. Tests of
/// many boxes or frusta at once (batch.cpp) compute the same values with the same template (aabb_frame-inl.h).
inline constexpr double kPlaneError = rounding_error(1 + 1 + 1 + 3 + 1);
inline constexpr double kOffsetError = rounding_error(3 + 1);

/// The same value in floats, v = 2^-24 in place of u, of a plane whose coefficients were rounded to floats. The box is
/// rounded to floats relative to the origin: a rounding by u (1 + v) more, which second-order terms cover. A component of
/// the normal is off by v |n_k| more, and the offset by v |w|. So the value is off by at most
///   (g(7) + v) sum_k |n_k| R + slope * R + (g(4) + v) |w| + base,
/// with g and v of floats, and slope and base those of the plane in doubles. The constants have one more v for second-order
/// terms. Four times slope and base are taken: a value beyond this bound is then at least three times beyond that of
/// doubles, whose filter would decide it in the same way. Floats that are flushed to zero or rounded below the normal range
/// change by at most 2^-126: with normals below 2^51 and coordinates below 2^60, a dozen such changes, each times the other
/// factor, are below 2^-60. The reach takes five roundings from the box to the bound, and the bound two when it is stored.
inline constexpr double kFloatRoundoff = 0x1p-24;
inline constexpr double kCoarsePlaneError = (7 + 1 + 1) * kFloatRoundoff, kCoarseOffsetError = (4 + 1 + 1) * kFloatRoundoff;
inline constexpr double kCoarseUnderflow = 0x1p-60, kCoarseInflation = 1 + 16 * kFloatRoundoff;
/// Boxes that reach this far, and planes with such an offset, are left to doubles, so that no float overflows: a normal is
/// below 2^51, and the values are sums of four terms below 2^113.
inline constexpr double kCoarseReach = 0x1p60, kCoarseOffset = 0x1p110;

/// Value of a refined plane at a vertex y = x + t, |t_k| <= u |x_k|. The plane has n + m in place of n and w + v in place of
/// w, with |m_k| <= u |n_k| and |v| <= u |w|. The products n_k x_k and their sums with w are computed by error-free
/// transformations; what these lose and what the tails add is summed in doubles. With S = sum_k |n_k x_k| + |w|, up to
/// second order:
///
///   lost     of three products at most u S together, of three partial sums at most u S each; four additions at most: 4 * 4
///   tails    n_k t_k, m_k x_k and v: at most 2 u S together; one product and four additions at most: 2 * 5
///   left out m_k t_k: at most u^2 S
///
/// in units of u^2 S. The last addition, of the value's high part, rounds without a change of sign, and does not carry the
/// value across the bound. S is computed with one rounding of n_k x_k, two additions, the product with the constant and a
/// sum: five. The constant is rounded up to a power of two. That slack does not matter: a value that doubles leave within
/// 2^-101 S of zero is zero in all but contrived cases, and no bound could decide it.
inline constexpr double kRefinedError = 32 * kUnitRoundoff * kUnitRoundoff;
static_assert(kRefinedError >= rounding_error(4 * 4 + 2 * 5 + 1) * kUnitRoundoff);

/// a b - c d, in twice the precision of a double (product_difference.h). Each of the four is given as h + t, |t| <= u |h|.
/// The products of two h and their difference are computed by error-free transformations; what these lose and what the tails
/// add is summed in doubles. With S = |h_a h_b| + |h_c h_d|, up to second order:
///
///   tails    four products h t: at most 2 u S together; one product, a sum, a difference and the last sum: 2 * 4
///   lost     of two products at most u S together, and of their difference u S; at most three additions: 2 * 3
///   left out t_a t_b and t_c t_d: at most u^2 S
///
/// in units of u^2 S. S is computed with one rounding of a product, an addition and the product with the constant. The
/// constant is rounded up to a power of two.
inline constexpr double kProductDifferenceError = 16 * kUnitRoundoff * kUnitRoundoff;
static_assert(kProductDifferenceError >= rounding_error(2 * 4 + 2 * 3 + 1) * kUnitRoundoff);

/// Half-space value g(x) = n_x x + n_y y + n_z z + d with coefficients and coordinates given. Each product is rounded once
/// and passes through two additions, so the sum s of the products is off by at most g(3) sum_k |n_k x_k|. The last addition,
/// of d, rounds without a change of sign: fl(s + d) has the sign of g when it exceeds the bound. The sum of magnitudes takes
/// the same three roundings, and the product with the constant one more.
inline constexpr double kHalfSpaceError = rounding_error(1 + 2);

}  // namespace occlude::kernel
