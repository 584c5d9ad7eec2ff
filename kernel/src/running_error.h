// SPDX-License-Identifier: MIT
// A double that carries a bound on its own error. The filter uses it for expressions too long for a bound derived by hand.
#pragma once

#include <cmath>

#include "error_bounds.h"

namespace occlude::kernel {

/// |true value - value| <= error, maintained through +, - and * (Wilkinson's running error analysis). `Real` is double, or a
/// number type that tracks rounding errors.
template <class Real>
struct BasicRunningError {
  Real value = 0, error = 0;

  /// a - b of two given doubles.
  static BasicRunningError difference(const Real& a, const Real& b) {
    using std::fabs;
    const Real rounded = a - b;
    return {rounded, kUnitRoundoff * fabs(rounded)};
  }

  BasicRunningError operator-() const { return {-value, error}; }

  friend BasicRunningError operator+(const BasicRunningError& a, const BasicRunningError& b) {
    using std::fabs;
    const Real sum = a.value + b.value;
    return {sum, inflated<BoundOf::running_sum>(a.error + b.error + kUnitRoundoff * fabs(sum))};
  }
  friend BasicRunningError operator-(const BasicRunningError& a, const BasicRunningError& b) { return a + -b; }
  friend BasicRunningError operator*(const BasicRunningError& a, const BasicRunningError& b) {
    using std::fabs;
    const Real product = a.value * b.value;
    const Real inherited = fabs(a.value) * b.error + fabs(b.value) * a.error + a.error * b.error;
    return {product, inflated<BoundOf::running_product>(inherited + kUnitRoundoff * fabs(product))};
  }
};

using RunningError = BasicRunningError<double>;

}  // namespace occlude::kernel
