// SPDX-License-Identifier: MIT
// Integers of any size: exact numbers for expressions so long that expansions would underflow.
#pragma once

#include <cstdint>
#include <vector>

namespace occlude::kernel {

/// A small number is stored as it is, any other as sign and magnitude. Every operation is exact. The time of a product grows
/// with the product of the lengths.
class BigInteger {
 public:
  BigInteger() = default;
  BigInteger(std::int64_t small) : small_(small) {}  // NOLINT(google-explicit-constructor): numbers like any other
  /// x 2^shift. REQUIRES: x is finite and not subnormal, and x 2^shift is an integer.
  static BigInteger scaled(double x, int shift);

  [[nodiscard]] int sign() const {
    if (is_small()) return (small_ > 0) - (small_ < 0);
    return is_negative_ ? -1 : 1;
  }

  BigInteger operator-() const;
  friend BigInteger operator+(const BigInteger& a, const BigInteger& b) {
    return a.is_below(kSummand) && b.is_below(kSummand) ? BigInteger(a.small_ + b.small_) : sum(a, b);
  }
  friend BigInteger operator-(const BigInteger& a, const BigInteger& b) { return a + -b; }
  friend BigInteger operator*(const BigInteger& a, const BigInteger& b) {
    return a.is_below(kFactor) && b.is_below(kFactor) ? BigInteger(a.small_ * b.small_) : product(a, b);
  }

 private:
  using Limbs = std::vector<std::uint32_t>;  ///< lowest first, the highest is not 0; empty for a small number

  /// Two small numbers with magnitudes below kSummand have a small sum; with magnitudes below kFactor, a small product.
  static constexpr std::int64_t kSummand = std::int64_t{1} << 62U, kFactor = std::int64_t{1} << 31U;

  BigInteger(bool is_negative, Limbs limbs);
  static BigInteger sum(const BigInteger& a, const BigInteger& b);
  static BigInteger product(const BigInteger& a, const BigInteger& b);

  [[nodiscard]] bool is_small() const { return limbs_.empty(); }
  [[nodiscard]] bool is_below(std::int64_t limit) const { return is_small() && small_ < limit && small_ > -limit; }
  [[nodiscard]] bool is_negative() const { return is_small() ? small_ < 0 : is_negative_; }
  [[nodiscard]] Limbs magnitude() const;

  std::int64_t small_ = 0;
  bool is_negative_ = false;
  Limbs limbs_;
};

}  // namespace occlude::kernel
