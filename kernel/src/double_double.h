// SPDX-License-Identifier: MIT
// A number in twice the precision of a double that carries a bound on its own error: the first step of the exact stage. Its
// error is 0 for a difference of two doubles, and for a sum or product of doubles that is itself a double.
#pragma once

#include "error_free.h"
#include "product_difference.h"
#include "running_error.h"
#include "vector3.h"

namespace occlude::kernel {

/// |true value - (high + low.value)| <= low.error, and high is the double nearest to high + low.value.
struct DoubleDouble {
  double high = 0;
  RunningError low;

  static DoubleDouble difference(double a, double b) {
    const TwoTerms d = two_difference(a, b);
    return {d.high, {d.low, 0}};
  }

  /// The sign, or 0 when the bound cannot tell it. With low.error = 0 it is always the true sign.
  [[nodiscard]] int certain_sign() const {
    // |high + low.value| > |high| / 2, because low.value is at most half an ulp of high.
    if (low.error != 0 && std::fabs(high) * 0.5 <= low.error) return 0;
    return (high > 0) - (high < 0);
  }
  [[nodiscard]] bool is_certain() const { return low.error == 0 || certain_sign() != 0; }

  DoubleDouble operator-() const { return {-high, -low}; }

  friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const TwoTerms sum = two_sum(a.high, b.high);
    return normalised(sum.high, a.low + b.low + RunningError{sum.low, 0});
  }
  friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
  friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const TwoTerms product = two_product(a.high, b.high);
    const RunningError a_high{a.high, 0}, b_high{b.high, 0};
    return normalised(product.high, (a_high * b.low + b_high * a.low) + (a.low * b.low + RunningError{product.low, 0}));
  }

 private:
  static DoubleDouble normalised(double high, const RunningError& low) {
    const TwoTerms sum = two_sum(high, low.value);
    return {sum.high, {sum.low, low.error}};
  }
};

/// One product_difference() for each component, which is faster than the operations one by one.
[[nodiscard]] inline Vector3<DoubleDouble> cross_of_differences(const Vector3<DoubleDouble>& a,
                                                                const Vector3<DoubleDouble>& b) {
  const auto minor = [](const DoubleDouble& p, const DoubleDouble& q, const DoubleDouble& r, const DoubleDouble& s) {
    const auto terms = [](const DoubleDouble& x) { return TwoTerms{x.high, x.low.value}; };
    const auto [high, low, error] = product_difference<double>(terms(p), terms(q), terms(r), terms(s));
    return DoubleDouble{high, {low, error}};
  };
  return {minor(a.y, b.z, a.z, b.y), minor(a.z, b.x, a.x, b.z), minor(a.x, b.y, a.y, b.x)};
}

}  // namespace occlude::kernel
