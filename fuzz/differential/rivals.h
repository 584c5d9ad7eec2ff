// SPDX-License-Identifier: MIT
// Arithmetics that others use for such a test. They run through the kernel's `plain` test (kernel/src/arithmetic.h).
#pragma once

#include <cmath>

#include "occlude/fuzz/case.h"
#include "occlude/kernel/overlap.h"

namespace occlude::fuzz {

/// A double that is rounded to the 24 bits of a float after every operation. It keeps the exponents of doubles, because lost
/// precision is counted and not overflow.
struct Float32 {
  double value = 0;

  static Float32 rounded(double x) {
    const double scaled = 0x1.00000008p29 * x;  // 2^29 + 1 leaves 53 - 29 bits (Veltkamp)
    return {scaled - (scaled - x)};
  }

  Float32 operator-() const { return {-value}; }
  friend Float32 operator+(Float32 a, Float32 b) { return rounded(a.value + b.value); }
  friend Float32 operator-(Float32 a, Float32 b) { return rounded(a.value - b.value); }
  friend Float32 operator*(Float32 a, Float32 b) { return rounded(a.value * b.value); }
};

/// Doubles whose products are fused with the sums around them, as compilers do for processors that can.
struct Fused {
  double value = 0;

  struct Product {
    double a, b;
    operator Fused() const { return {a * b}; }  // NOLINT: a product to which nothing is added
  };

  Fused operator-() const { return {-value}; }
  friend Fused operator+(Fused a, Fused b) { return {a.value + b.value}; }
  friend Fused operator-(Fused a, Fused b) { return {a.value - b.value}; }
  friend Product operator*(Fused a, Fused b) { return {a.value, b.value}; }
  friend Fused operator+(Product p, Fused c) { return {std::fma(p.a, p.b, c.value)}; }
  friend Fused operator+(Fused c, Product p) { return p + c; }
  friend Fused operator+(Product p, Product q) { return p + Fused(q); }
  friend Fused operator-(Product p, Product q) { return {std::fma(p.a, p.b, -(q.a * q.b))}; }
};

/// The relation of the box to the frustum by the paper's test in each arithmetic.
[[nodiscard]] kernel::Relation overlap_float32(const kernel::ShadowFrustum& frustum, const Box& box);
[[nodiscard]] kernel::Relation overlap_fused(const kernel::ShadowFrustum& frustum, const Box& box);

}  // namespace occlude::fuzz
