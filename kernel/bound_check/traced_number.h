// SPDX-License-Identifier: MIT
// A number that follows its roundings: the kernel's own templates, evaluated in it, tell how far off they can be.
//
// Every rounded operation multiplies its result by 1 + d with a new unknown d, |d| <= u. A number is a polynomial in these
// unknowns: the terms up to the second degree exactly, the others as a bound. What different operations have in common,
// such as a coordinate rounded once and used twice, stays in common; what cancels, cancels.
#pragma once

#include <array>
#include <map>

#include "exact.h"

namespace occlude::bound_check {

class TracedNumber {
 public:
  TracedNumber(double x = 0);  // implicit: the kernel's templates mix numbers and doubles

  /// An unknown part of this number, at most u of it in magnitude: what a double leaves of a number it is nearest to.
  [[nodiscard]] TracedNumber tail() const;

  [[nodiscard]] const Exact& leading() const;
  /// Its magnitude is at most this.
  [[nodiscard]] Exact most() const;
  /// It is at least this. REQUIRES: a leading term that is not negative.
  [[nodiscard]] Exact least() const;

  TracedNumber operator-() const;
  friend TracedNumber operator+(const TracedNumber& a, const TracedNumber& b) { return sum(a, b).rounded(); }
  friend TracedNumber operator-(const TracedNumber& a, const TracedNumber& b) { return sum(a, -b).rounded(); }
  friend TracedNumber operator*(const TracedNumber& a, const TracedNumber& b) { return product(a, b).rounded(); }
  friend bool operator<(const TracedNumber& a, const TracedNumber& b) { return a.leading() < b.leading(); }
  friend bool operator==(const TracedNumber& a, const TracedNumber& b) { return sum(a, -b).most() == 0; }

  /// Without rounding.
  static TracedNumber sum(const TracedNumber& a, const TracedNumber& b);
  static TracedNumber product(const TracedNumber& a, const TracedNumber& b);
  [[nodiscard]] TracedNumber rounded() const;
  /// What it was before its last rounding.
  [[nodiscard]] TracedNumber unrounded() const;

 private:
  using Unknowns = std::array<int, 2>;  ///< in descending order; 0 stands for none

  static int degree(const Unknowns& unknowns) { return (unknowns[0] != 0) + (unknowns[1] != 0); }
  static TracedNumber unknown(int number);
  void add(const Unknowns& unknowns, const Exact& coefficient);

  std::map<Unknowns, Exact> terms_;
  int last_ = 0;      ///< the unknown of the last rounding
  Exact beyond_ = 0;  ///< the terms of higher degree are at most this, in units of u^3
};

[[nodiscard]] TracedNumber fabs(const TracedNumber& x);

/// A rounded result and, exactly, what rounding lost: what the transformations of error_free.h promise.
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
