// SPDX-License-Identifier: MIT
// Exact numbers: sums of doubles that do not overlap (Priest 1991, Shewchuk 1997, "Adaptive precision floating-point
// arithmetic and fast robust geometric predicates").
//
// REQUIRES: round to nearest and no overflow or underflow, which the legal range of the kernel guarantees.
#pragma once

#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

namespace occlude::kernel {

/// An exactly represented real: the terms grow in magnitude, are non-zero and non-overlapping; no term means zero.
class Expansion {
 public:
  Expansion() = default;
  explicit Expansion(double x) {
    if (x != 0) terms_.push_back(x);
  }

  /// a - b, exactly.
  static Expansion difference(double a, double b) {
    Expansion result;
    const double high = a - b;
    const double b_virtual = a - high;
    const double a_virtual = high + b_virtual;
    result.append((a - a_virtual) + (b_virtual - b));
    result.append(high);
    return result;
  }

  [[nodiscard]] int sign() const { return terms_.empty() ? 0 : terms_.back() > 0 ? 1 : -1; }

  Expansion operator-() const {
    Expansion result = *this;
    for (double& term : result.terms_) term = -term;
    return result;
  }

  friend Expansion operator+(const Expansion& a, const Expansion& b) { return add(a, b); }
  friend Expansion operator-(const Expansion& a, const Expansion& b) { return add(a, -b); }
  friend Expansion operator*(const Expansion& a, const Expansion& b) {
    const auto& [longer, shorter] = a.terms_.size() >= b.terms_.size() ? std::tie(a, b) : std::tie(b, a);
    Expansion product;
    for (const double factor : shorter.terms_) product = add(product, scale(longer, factor));
    return product;
  }

 private:
  void append(double term) {
    if (term != 0) terms_.push_back(term);
  }

  /// a + b as high + low, exactly, for any a and b (Knuth).
  static std::pair<double, double> two_sum(double a, double b) {
    const double high = a + b;
    const double b_virtual = high - a;
    return {high, (a - (high - b_virtual)) + (b - b_virtual)};
  }

  /// Merges the terms by magnitude and carries one running sum through them (Shewchuk's fast expansion sum). It needs and
  /// keeps terms that are strongly non-overlapping, as those of difference() and scale() are under round to even.
  static Expansion add(const Expansion& a, const Expansion& b) {
    Expansion result;
    result.terms_.reserve(a.terms_.size() + b.terms_.size());
    auto i = a.terms_.begin(), j = b.terms_.begin();
    double carry = 0;
    while (i != a.terms_.end() || j != b.terms_.end()) {
      const bool take_a = j == b.terms_.end() || (i != a.terms_.end() && std::fabs(*i) <= std::fabs(*j));
      const auto [high, low] = two_sum(carry, take_a ? *i++ : *j++);
      result.append(low);
      carry = high;
    }
    result.append(carry);
    return result;
  }

  /// a * factor (Shewchuk's scale expansion; the error of a product by one fused multiply-add, which is exact).
  static Expansion scale(const Expansion& a, double factor) {
    Expansion result;
    result.terms_.reserve(2 * a.terms_.size());
    double carry = 0;
    for (const double term : a.terms_) {
      const double high = term * factor;
      const double low = std::fma(term, factor, -high);
      const auto [middle, lowest] = two_sum(carry, low);
      result.append(lowest);
      const auto [top, next] = two_sum(high, middle);
      result.append(next);
      carry = top;
    }
    result.append(carry);
    return result;
  }

  std::vector<double> terms_;
};

}  // namespace occlude::kernel
