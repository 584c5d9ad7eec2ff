// SPDX-License-Identifier: MIT
// A double that carries a bound on its own error, for the filter of expressions too long for a bound worked out by hand.
#pragma once

#include <cmath>

#include "error_bounds.h"

namespace occlude::kernel {

/// |true value - value| <= error, maintained through +, - and * (Wilkinson's running error analysis).
struct RunningError {
  double value = 0, error = 0;

  /// a - b of two given doubles.
  static RunningError difference(double a, double b) {
    const double rounded = a - b;
    return {rounded, kUnitRoundoff * std::fabs(rounded)};
  }

  RunningError operator-() const { return {-value, error}; }

  friend RunningError operator+(const RunningError& a, const RunningError& b) {
    const double sum = a.value + b.value;
    return {sum, (a.error + b.error + kUnitRoundoff * std::fabs(sum)) * kBoundInflation};
  }
  friend RunningError operator-(const RunningError& a, const RunningError& b) { return a + -b; }
  friend RunningError operator*(const RunningError& a, const RunningError& b) {
    const double product = a.value * b.value;
    const double inherited = std::fabs(a.value) * b.error + std::fabs(b.value) * a.error + a.error * b.error;
    return {product, (inherited + kUnitRoundoff * std::fabs(product)) * kBoundInflation};
  }
};

}  // namespace occlude::kernel
