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

class TracedNumber {
 public:
  TracedNumber(double x = 0);  // implicit, because the kernel's templates mix numbers and doubles

  /// This number times a new unknown: what a number has beyond the double nearest to it is such a tail.
  [[nodiscard]] TracedNumber tail() const;

  [[nodiscard]] const Exact& leading() const;
  /// An upper bound on the magnitude.
  [[nodiscard]] Exact most() const;
  /// A lower bound on the number. REQUIRES: the leading term is not negative.
  [[nodiscard]] Exact least() const;

  TracedNumber operator-() const;
  friend TracedNumber operator+(const TracedNumber& a, const TracedNumber& b) { return sum(a, b).rounded(); }
  friend TracedNumber operator-(const TracedNumber& a, const TracedNumber& b) { return sum(a, -b).rounded(); }
  friend TracedNumber operator*(const TracedNumber& a, const TracedNumber& b) { return product(a, b).rounded(); }
  friend bool operator<(const TracedNumber& a, const TracedNumber& b) { return a.leading() < b.leading(); }
  friend bool operator==(const TracedNumber& a, const TracedNumber& b) { return sum(a, -b).most() == 0; }

  /// The sum and the product without rounding.
  static TracedNumber sum(const TracedNumber& a, const TracedNumber& b);
  static TracedNumber product(const TracedNumber& a, const TracedNumber& b);
  [[nodiscard]] TracedNumber rounded() const;
  /// The number before its last rounding.
  [[nodiscard]] TracedNumber unrounded() const;

 private:
  using Unknowns = std::array<int, 2>;  ///< in descending order; 0 for none

  static int degree(const Unknowns& unknowns) { return (unknowns[0] != 0) + (unknowns[1] != 0); }
  static TracedNumber unknown(int number);
  void add(const Unknowns& unknowns, const Exact& coefficient);

  std::map<Unknowns, Exact> terms_;
  int last_ = 0;      ///< the unknown of the last rounding
  Exact beyond_ = 0;  ///< an upper bound on the terms of higher degree, in units of u^3
};

[[nodiscard]] TracedNumber fabs(const TracedNumber& x);

/// A rounded result and exactly what rounding lost, as the transformations of error_free.h return them.
struct TracedTerms {
  TracedNumber high, low;
};
[[nodiscard]] TracedTerms two_sum(const TracedNumber& a, const TracedNumber& b);
[[nodiscard]] TracedTerms two_difference(const TracedNumber& a, const TracedNumber& b);
[[nodiscard]] TracedTerms two_product(const TracedNumber& a, const TracedNumber& b);

/// An arithmetic for the kernel's templates (arithmetic.h).
struct TracingArithmetic {
  using Number = TracedNumber;
  static TracedNumber constant(const TracedNumber& x) { return x; }
  static TracedNumber difference(double a, double b) { return TracedNumber(a) - TracedNumber(b); }
  static TracedNumber magnitude(const TracedNumber& x) { return fabs(x); }
  static TracedNumber rounded(const TracedNumber& x) { return x; }
};

}  // namespace occlude::bound_check
