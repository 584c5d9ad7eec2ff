// SPDX-License-Identifier: MIT
// The three arithmetics in which one and the same test can be run. Reading order: 4.
//
// A test is written once, as a template over an arithmetic A: numbers are A::Number, made from differences of input doubles
// and combined by + - *; the only question ever asked of a number is its sign, and it is asked of the arithmetic object.
#pragma once

#include "expansion.h"
#include "occlude/kernel/types.h"
#include "running_error.h"

namespace occlude::kernel {

/// Double operations and their rounding: the paper's (section 6.4).
struct PlainArithmetic {
  using Number = double;
  static double constant(double x) { return x; }
  static double difference(double a, double b) { return a - b; }
  static int sign(double x) { return (x > 0) - (x < 0); }
  static bool failed() { return false; }
};

/// Doubles with a running error bound. A sign that the bound cannot decide is answered 0 and remembered: what was computed
/// then means nothing, and failed() says so.
class FilterArithmetic {
 public:
  using Number = RunningError;
  static RunningError constant(double x) { return {x, 0}; }
  static RunningError difference(double a, double b) { return RunningError::difference(a, b); }
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

/// Exact.
struct ExactArithmetic {
  using Number = Expansion;
  static Expansion constant(double x) { return Expansion(x); }
  static Expansion difference(double a, double b) { return Expansion::difference(a, b); }
  static int sign(const Expansion& x) { return x.sign(); }
  static bool failed() { return false; }
};

/// The result of `question(arithmetic)`, by the filter where its bounds suffice, else exactly; `stage` learns which.
template <class Question>
[[nodiscard]] auto certified(Question&& question, Stage* stage = nullptr) {
  FilterArithmetic filter;
  const auto answer = question(filter);
  if (!filter.failed()) return answer;
  if (stage) *stage = Stage::exact;
  ExactArithmetic exact;
  return question(exact);
}

}  // namespace occlude::kernel
