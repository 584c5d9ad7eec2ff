// SPDX-License-Identifier: MIT
// The arithmetics in which the same expression can be evaluated. Reading order: 4.
//
// An expression is written once, as a template over an arithmetic A. Its numbers are A::Number, made from differences of
// input doubles and combined by + - *. The only question ever asked of a number is its sign, and the arithmetic object
// answers it. An arithmetic that cannot tell a sign answers 0 and remembers this. What was computed then means nothing, and
// failed() says so.
//
// The steps by which a sign is found. Read a column downwards: each step takes what the one above it leaves open. All steps
// below the line are Stage::exact.
//
//   a plane at a point             a plane at an axis-aligned box     anything else
//   sign_at()                      box_planes_certified()             certified()
//
//   equal coordinates              doubles, with an error bound       doubles, with an error bound
//   is_defined_by()                FilterPlane (before it floats,     FilterArithmetic
//         |                        for a block of boxes)                    |
//         v                              |                                  |
//   doubles, with an error bound         |                                  |
//   FilterArithmetic                     |                                  |
//  -------|------------------------------|----------------------------------|---------------------------------------
//         |                              v                                  |
//         |                        equal coordinates                        |
//         |                        is_defined_by(), sign_across_axis()      |
//         v                              |                                  |
//   integers of fixed width              |                                  |
//   grid_sign()                          |                                  |
//         |                              |                                  |
//         v                              v                                  v
//   twice the precision, bounded   twice the precision, bounded       twice the precision, bounded
//   DoubleDoubleArithmetic         refined_sign()                     DoubleDoubleArithmetic
//         |                              |                                  |
//         |                              v                                  |
//         |                        integers of fixed width                  |
//         |                        grid_extremal_sign()                     |
//         |                              |                                  |
//         v                              v                                  v
//   expansions, always certain     expansions, always certain         expansions, always certain
//   ExactArithmetic                ExactArithmetic                    ExactArithmetic
#pragma once

#include <cmath>

#include "double_double.h"
#include "expansion.h"
#include "occlude/kernel/types.h"
#include "running_error.h"

namespace occlude::kernel {

/// Plain doubles with their rounding, as in the paper (section 6.4).
struct PlainArithmetic {
  using Number = double;
  static double constant(double x) { return x; }
  static double difference(double a, double b) { return a - b; }
  static double magnitude(double x) { return std::fabs(x); }
  static double rounded(double x) { return x; }
  static int sign(double x) { return (x > 0) - (x < 0); }
};

/// Doubles with a running error bound.
class FilterArithmetic {
 public:
  using Number = RunningError;
  static RunningError constant(double x) { return {x, 0}; }
  static RunningError difference(double a, double b) { return RunningError::difference(a, b); }
  static RunningError magnitude(const RunningError& x) { return {std::fabs(x.value), x.error}; }
  int sign(const RunningError& x) {
    if (x.value > x.error) return 1;
    if (x.value < -x.error) return -1;
    if (x.error != 0) failed_ = true;
    return 0;
  }
  [[nodiscard]] bool failed() const { return failed_; }

 private:
  bool failed_ = false;
};

/// Twice the precision of a double, with a running error bound.
class DoubleDoubleArithmetic {
 public:
  using Number = DoubleDouble;
  static DoubleDouble constant(double x) { return {x, {}}; }
  static DoubleDouble difference(double a, double b) { return DoubleDouble::difference(a, b); }
  static DoubleDouble magnitude(const DoubleDouble& x) { return x.high < 0 ? -x : x; }
  int sign(const DoubleDouble& x) {
    if (!x.is_certain()) failed_ = true;
    return x.certain_sign();
  }
  [[nodiscard]] bool failed() const { return failed_; }

 private:
  bool failed_ = false;
};

/// Exact numbers: every sign is certain.
struct ExactArithmetic {
  using Number = Expansion;
  static Expansion constant(double x) { return Expansion(x); }
  static Expansion difference(double a, double b) { return Expansion::difference(a, b); }
  static Expansion magnitude(const Expansion& x) { return x.sign() < 0 ? -x : x; }
  static int sign(const Expansion& x) { return x.sign(); }
  static bool failed() { return false; }
};

/// The exact result of `question(arithmetic)`, from the first step of the exact stage that can tell.
template <class Question>
[[nodiscard]] auto exactly(Question&& question) {
  DoubleDoubleArithmetic twice;
  const auto answer = question(twice);
  if (!twice.failed()) return answer;
  ExactArithmetic exact;
  return question(exact);
}

/// The exact result of `question(arithmetic)`: from the filter where its bounds suffice, else from the exact stage. In the
/// second case `stage` is set to Stage::exact.
template <class Question>
[[nodiscard]] auto certified(Question&& question, Stage* stage = nullptr) {
  FilterArithmetic filter;
  const auto answer = question(filter);
  if (!filter.failed()) return answer;
  if (stage) *stage = Stage::exact;
  return exactly(question);
}

}  // namespace occlude::kernel
