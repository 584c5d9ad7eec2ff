// SPDX-License-Identifier: MIT
// Exact numbers: sums of doubles that do not overlap (Priest 1991, Shewchuk 1997, "Adaptive precision floating-point
// arithmetic and fast robust geometric predicates").
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>

#include "error_free.h"

namespace occlude::kernel {

/// A real number, represented exactly. The terms are in order of growing magnitude, not zero, and do not overlap. The number
/// without terms is zero.
class Expansion {
 public:
  Expansion() = default;
  explicit Expansion(double x) { append(x); }
  Expansion(const Expansion& other) : size_(other.size_) { std::copy_n(other.terms_.begin(), size_, terms_.begin()); }
  Expansion& operator=(const Expansion& other) {
    size_ = other.size_;
    std::copy_n(other.terms_.begin(), size_, terms_.begin());
    return *this;
  }
  ~Expansion() = default;

  /// a - b, exactly.
  static Expansion difference(double a, double b) {
    Expansion result;
    const TwoTerms d = two_difference(a, b);
    result.append(d.low);
    result.append(d.high);
    return result;
  }

  [[nodiscard]] int sign() const { return size_ == 0 ? 0 : terms_[size_ - 1] > 0 ? 1 : -1; }

  Expansion operator-() const {
    Expansion result = *this;
    std::for_each_n(result.terms_.begin(), size_, [](double& term) { term = -term; });
    return result;
  }

  friend Expansion operator+(const Expansion& a, const Expansion& b) { return Terms().add(a.view(), b.view()).compressed(); }
  friend Expansion operator-(const Expansion& a, const Expansion& b) { return a + -b; }
  friend Expansion operator*(const Expansion& a, const Expansion& b) {
    const auto& [longer, shorter] = a.size_ >= b.size_ ? std::tie(a, b) : std::tie(b, a);
    Expansion product;
    for (std::size_t i = 0; i < shorter.size_; ++i) {
      const Terms scaled = Terms().scale(longer.view(), shorter.terms_[i]);
      product = Terms().add(product.view(), scaled.view()).compressed();
    }
    return product;
  }

 private:
  /// Compressed terms stand at least 53 binary places apart. The lowest bit of an input is at least 2^-152 and the kernel
  /// multiplies at most six of them: all bits lie between 2^-912 and 2^(6 * 101 + 20), which 30 terms span; for nine see
  /// moderate.h. Numbers that are
  /// not legal may need more. Then the sum means nothing, and the terms beyond the capacity are dropped.
  static constexpr std::size_t kCapacity = 32;

  struct View {
    const double* first;
    std::size_t size;
  };

  /// Terms of a sum or of a scaled expansion before it is compressed.
  class Terms {
   public:
    /// Merges the terms by magnitude and carries one running sum through them (Shewchuk's fast expansion sum). REQUIRES:
    /// strongly non-overlapping terms, such as those of compressed() and scale() under round to even.
    Terms& add(View a, View b) {
      std::size_t i = 0, j = 0;
      double carry = 0;
      while (i < a.size || j < b.size) {
        const bool take_a = j == b.size || (i < a.size && std::fabs(a.first[i]) <= std::fabs(b.first[j]));
        const auto [high, low] = two_sum(carry, take_a ? a.first[i++] : b.first[j++]);
        append(low);
        carry = high;
      }
      append(carry);
      return *this;
    }

    /// a * factor (Shewchuk's scale expansion).
    Terms& scale(View a, double factor) {
      double carry = 0;
      for (std::size_t i = 0; i < a.size; ++i) {
        const auto [high, low] = two_product(a.first[i], factor);
        const auto [middle, lowest] = two_sum(carry, low);
        append(lowest);
        const auto [top, next] = fast_two_sum(high, middle);
        append(next);
        carry = top;
      }
      append(carry);
      return *this;
    }

    /// The same number in as few terms as it needs (Shewchuk's compress).
    [[nodiscard]] Expansion compressed() {
      Expansion result;
      if (size_ == 0) return result;
      std::size_t bottom = size_ - 1;
      double carry = terms_[bottom];
      for (std::size_t i = size_ - 1; i-- > 0;) {
        const auto [high, low] = fast_two_sum(carry, terms_[i]);
        if (low != 0) {
          terms_[bottom--] = high;
          carry = low;
        } else {
          carry = high;
        }
      }
      terms_[bottom] = carry;
      for (std::size_t i = bottom + 1; i < size_; ++i) {
        const auto [high, low] = fast_two_sum(terms_[i], carry);
        result.append(low);
        carry = high;
      }
      result.append(carry);
      return result;
    }

    [[nodiscard]] View view() const { return {terms_.data(), size_}; }

   private:
    void append(double term) {
      if (term != 0) terms_[size_++] = term;
    }

    /// scale() makes twice as many terms as it is given and a carry; add() makes the terms of both and a carry. The most are
    /// the terms of a product so far and those of a scaled expansion. All of them can be non-zero only with numbers that are
    /// not legal, such as NaN.
    std::array<double, 3 * kCapacity + 2> terms_;
    std::size_t size_ = 0;
  };

  void append(double term) {
    if (term == 0 || size_ == kCapacity) return;
    terms_[size_++] = term;
  }
  [[nodiscard]] View view() const { return {terms_.data(), size_}; }

  std::array<double, kCapacity> terms_;
  std::size_t size_ = 0;
};

}  // namespace occlude::kernel
