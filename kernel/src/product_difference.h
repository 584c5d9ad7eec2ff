// SPDX-License-Identifier: MIT
// What the coefficients of planes are made of, in twice the precision of a double: a b - c d, where a, b, c and d are
// differences of coordinates.
#pragma once

#include <cmath>

#include "error_bounds.h"
#include "error_free.h"

namespace occlude::kernel {

/// A rounded number: |true value - (high + low)| <= error, and high is the double nearest to high + low. `Real` is double or
/// a number type that tracks rounding errors.
template <class Real>
struct RoundedNumber {
  Real high, low, error;
};

/// a b - c d, each given as a double and exactly what it is off by, at most half an ulp. The error is 0 if nothing was
/// rounded.
template <class Real, class Terms>
[[nodiscard]] RoundedNumber<Real> product_difference(const Terms& a, const Terms& b, const Terms& c, const Terms& d) {
  using std::fabs;
  const auto ab = two_product(a.high, b.high), cd = two_product(c.high, d.high), most = two_difference(ab.high, cd.high);
  const Real tails = (a.high * b.low + a.low * b.high) - (c.high * d.low + c.low * d.high);
  const Real lost = (ab.low - cd.low) + most.low;
  const auto sum = two_sum(most.high, lost + tails);
  const bool is_exact = ab.low == 0 && cd.low == 0 && most.low == 0 && a.low == 0 && b.low == 0 && c.low == 0 && d.low == 0;
  const Real magnitude = fabs(ab.high) + fabs(cd.high);
  return {sum.high, sum.low, is_exact ? Real(0) : kProductDifferenceError * magnitude};
}

}  // namespace occlude::kernel
