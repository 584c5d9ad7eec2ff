// SPDX-License-Identifier: MIT
// A number that traces its roundings. The kernel's own templates, evaluated with such numbers, show how far off they can be.
//
// Every rounded operation multiplies its result by 1 + d with a new unknown d, |d| <= u. A number is a polynomial in these
// unknowns. Terms up to the second degree are exact, and the others are covered by a bound. A rounding that several
// operations share, such as that of a coordinate used twice, stays the same unknown in all of them, and terms that cancel do
// cancel.
#pragma once

#include <array>
#include <map>

#include "exact.h"

namespace occlude::bound_check {

/// `kBits` is the number of bits of a mantissa: u = 2^-kBits.
template <int kBits>
class BasicTracedNumber {
 public:
  BasicTracedNumber(double x = 0);  // implicit, because the kernel's templates mix numbers and doubles

  /// This number times a new unknown: what a number has beyond the double nearest to it is such a tail.
  [[nodiscard]] BasicTracedNumber tail() const;

  [[nodiscard]] const Exact& leading() const;
  /// An upper bound on the magnitude.
  [[nodiscard]] Exact most() const;
  /// A lower bound on the number. REQUIRES: the leading term is not negative.
  [[nodiscard]] Exact least() const;

  BasicTracedNumber operator-() const;
  friend BasicTracedNumber operator+(const BasicTracedNumber& a, const BasicTracedNumber& b) { return sum(a, b).rounded(); }
  friend BasicTracedNumber operator-(const BasicTracedNumber& a, const BasicTracedNumber& b) { return sum(a, -b).rounded(); }
  friend BasicTracedNumber operator*(const BasicTracedNumber& a, const BasicTracedNumber& b) {
    return product(a, b).rounded();
  }
  friend BasicTracedNumber operator/(const BasicTracedNumber& a, const BasicTracedNumber& b) {
    return product(a, b.inverse()).rounded();
  }
  friend bool operator<(const BasicTracedNumber& a, const BasicTracedNumber& b) { return a.leading() < b.leading(); }
  friend bool operator==(const BasicTracedNumber& a, const BasicTracedNumber& b) { return sum(a, -b).most() == 0; }

  /// The sum and the product without rounding.
  static BasicTracedNumber sum(const BasicTracedNumber& a, const BasicTracedNumber& b);
  static BasicTracedNumber product(const BasicTracedNumber& a, const BasicTracedNumber& b);
  /// 1 / x without rounding. REQUIRES: the leading term is not 0.
  [[nodiscard]] BasicTracedNumber inverse() const;
  /// The square root without rounding. REQUIRES: the leading term is 1.
  [[nodiscard]] BasicTracedNumber root() const;
  [[nodiscard]] BasicTracedNumber rounded() const;
  /// The number before its last rounding.
  [[nodiscard]] BasicTracedNumber unrounded() const;

 private:
  using Unknowns = std::array<int, 2>;  ///< in descending order; 0 for none

  static int degree(const Unknowns& unknowns) { return (unknowns[0] != 0) + (unknowns[1] != 0); }
  static BasicTracedNumber unknown(int number);
  /// 1 + first x + second x^2 of a number without a leading term. The rest of a series is at most beyond |x|^3.
  static BasicTracedNumber series(const BasicTracedNumber& x, const Exact& first, const Exact& second, const Exact& beyond);
  void add(const Unknowns& unknowns, const Exact& coefficient);

  std::map<Unknowns, Exact> terms_;
  int last_ = 0;      ///< the unknown of the last rounding
  Exact beyond_ = 0;  ///< an upper bound on the terms of higher degree, in units of u^3
};

/// A double, and a float.
using TracedNumber = BasicTracedNumber<53>;
using TracedFloat = BasicTracedNumber<24>;

template <int kBits>
[[nodiscard]] BasicTracedNumber<kBits> fabs(const BasicTracedNumber<kBits>& x) {
  return x.leading() < 0 ? -x : x;
}

/// A rounded result and exactly what rounding lost, as the transformations of error_free.h return them.
struct TracedTerms {
  TracedNumber high, low;
};
[[nodiscard]] TracedTerms two_sum(const TracedNumber& a, const TracedNumber& b);
[[nodiscard]] TracedTerms two_difference(const TracedNumber& a, const TracedNumber& b);
[[nodiscard]] TracedTerms two_product(const TracedNumber& a, const TracedNumber& b);

/// An arithmetic for the kernel's templates (arithmetic.h).
template <int kBits>
struct BasicTracingArithmetic {
  using Number = BasicTracedNumber<kBits>;
  static Number constant(const Number& x) { return x; }
  static Number difference(double a, double b) { return Number(a) - Number(b); }
  static Number magnitude(const Number& x) { return fabs(x); }
  static Number rounded(const Number& x) { return x; }
};
using TracingArithmetic = BasicTracingArithmetic<53>;

}  // namespace occlude::bound_check
