// SPDX-License-Identifier: MIT
// Error-free transformations: a rounded result together with exactly what rounding lost (Knuth 1969, Dekker 1971).
//
// REQUIRES: round to nearest (validity.h), operations as they are written (cmake/compile_options.cmake), no overflow, no
// underflow: the legal range (validity.h) guarantees the last two.
#pragma once

#include <cmath>

namespace occlude::kernel {

/// high + low is the exact result of an operation; high is the rounded result.
struct TwoTerms {
  double high, low;
};

[[nodiscard]] inline TwoTerms two_sum(double a, double b) {
  const double high = a + b;
  const double b_part = high - a;
  return {high, (a - (high - b_part)) + (b - b_part)};
}

/// REQUIRES: |a| >= |b| or a = 0.
[[nodiscard]] inline TwoTerms fast_two_sum(double a, double b) {
  const double high = a + b;
  return {high, b - (high - a)};
}

[[nodiscard]] inline TwoTerms two_difference(double a, double b) {
  const double high = a - b;
  const double b_part = a - high;
  return {high, (a - (high + b_part)) + (b_part - b)};
}

/// Splits a double into the sum of two numbers of 26 bits (Veltkamp). Products of such numbers are exact.
[[nodiscard]] inline TwoTerms split(double a) {
  const double scaled = 0x1.0000002p27 * a;  // 2^27 + 1
  const double high = scaled - (scaled - a);
  return {high, a - high};
}

/// a * b. Where a fused multiply-add is fast, it gives `low` in one more instruction. Both ways give the same two numbers.
[[nodiscard]] inline TwoTerms two_product(double a, double b) {
  const double high = a * b;
#ifdef __FP_FAST_FMA
  return {high, std::fma(a, b, -high)};
#else
  const auto [a1, a2] = split(a);
  const auto [b1, b2] = split(b);
  return {high, ((a1 * b1 - high) + a1 * b2 + a2 * b1) + a2 * b2};
#endif
}

}  // namespace occlude::kernel
