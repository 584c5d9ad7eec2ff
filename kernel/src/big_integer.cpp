// SPDX-License-Identifier: MIT
#include "big_integer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "binary_parts.h"

namespace occlude::kernel {
namespace {

using Limb = std::uint32_t;
using Wide = std::uint64_t;
using Limbs = std::vector<Limb>;

constexpr int kLimbBits = 32;

/// The numbers may have leading zeros.
bool is_less(const Limbs& a, const Limbs& b) {
  const auto limb = [](const Limbs& of, std::size_t i) { return i < of.size() ? of[i] : 0; };
  for (std::size_t i = std::max(a.size(), b.size()); i-- > 0;) {
    if (limb(a, i) != limb(b, i)) return limb(a, i) < limb(b, i);
  }
  return false;
}

Limbs sum(const Limbs& a, const Limbs& b) {
  const std::size_t size = std::max(a.size(), b.size());
  Limbs result(size + 1);
  Wide carry = 0;
  for (std::size_t i = 0; i < size; ++i) {
    carry += Wide{i < a.size() ? a[i] : 0} + (i < b.size() ? b[i] : 0);
    result[i] = static_cast<Limb>(carry);
    carry >>= unsigned{kLimbBits};
  }
  result.back() = static_cast<Limb>(carry);
  return result;
}

/// REQUIRES: the first is not less than the second.
Limbs difference(const Limbs& greater, const Limbs& lesser) {
  Limbs result(greater.size());
  Wide borrow = 0;
  for (std::size_t i = 0; i < greater.size(); ++i) {
    const Wide taken = Wide{i < lesser.size() ? lesser[i] : 0} + borrow;
    borrow = greater[i] < taken ? 1 : 0;
    result[i] = static_cast<Limb>((borrow << unsigned{kLimbBits}) + greater[i] - taken);
  }
  return result;
}

}  // namespace

BigInteger::BigInteger(bool is_negative, Limbs limbs) : is_negative_(is_negative), limbs_(std::move(limbs)) {
  while (!limbs_.empty() && limbs_.back() == 0) limbs_.pop_back();
  if (limbs_.size() > 2 || (limbs_.size() == 2 && limbs_[1] >> (kLimbBits - 1) != 0)) return;
  Wide magnitude = 0;
  for (std::size_t i = limbs_.size(); i-- > 0;) magnitude = magnitude << unsigned{kLimbBits} | limbs_[i];
  small_ = is_negative ? -static_cast<std::int64_t>(magnitude) : static_cast<std::int64_t>(magnitude);
  limbs_.clear();
}

BigInteger::Limbs BigInteger::magnitude() const {
  if (!is_small()) return limbs_;
  // -2^63 is never small: the constructor keeps at most 63 bits in `small_`, and a sum of two numbers of 62 bits has no
  // more.
  const Wide size = static_cast<Wide>(small_ < 0 ? -small_ : small_);
  return {static_cast<Limb>(size), static_cast<Limb>(size >> unsigned{kLimbBits})};
}

BigInteger BigInteger::scaled(double x, int shift) {
  if (x == 0) return {};
  const BinaryParts parts(x);
  const Wide mantissa = parts.odd();
  const auto bits = static_cast<std::size_t>(parts.lowest() + shift);
  const std::size_t whole = bits / kLimbBits, rest = bits % kLimbBits;
  // The mantissa shifted by `rest` has at most 53 + 31 bits, which fit in three limbs.
  Limbs limbs(whole + 3);
  const Wide low = mantissa << rest;
  limbs[whole] = static_cast<Limb>(low);
  limbs[whole + 1] = static_cast<Limb>(low >> unsigned{kLimbBits});
  limbs[whole + 2] = rest == 0 ? 0 : static_cast<Limb>(mantissa >> (2 * kLimbBits - rest));
  return {std::signbit(x), std::move(limbs)};
}

BigInteger BigInteger::operator-() const {
  BigInteger result = *this;
  result.small_ = -small_;
  result.is_negative_ = !is_negative_;
  return result;
}

BigInteger BigInteger::sum(const BigInteger& a, const BigInteger& b) {
  const Limbs of_a = a.magnitude(), of_b = b.magnitude();
  const bool is_a_less = is_less(of_a, of_b);
  const Limbs& greater = is_a_less ? of_b : of_a;
  const Limbs& lesser = is_a_less ? of_a : of_b;
  const bool is_negative = (is_a_less ? b : a).is_negative();
  if (a.is_negative() != b.is_negative()) return {is_negative, kernel::difference(greater, lesser)};
  return {is_negative, kernel::sum(greater, lesser)};
}

BigInteger BigInteger::product(const BigInteger& a, const BigInteger& b) {
  const Limbs of_a = a.magnitude(), of_b = b.magnitude();
  Limbs result(of_a.size() + of_b.size());
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    Wide carry = 0;
    for (std::size_t j = 0; j < of_b.size(); ++j) {
      carry += Wide{of_a[i]} * of_b[j] + result[i + j];
      result[i + j] = static_cast<Limb>(carry);
      carry >>= unsigned{kLimbBits};
    }
    result[i + of_b.size()] = static_cast<Limb>(carry);
  }
  return {a.is_negative() != b.is_negative(), std::move(result)};
}

}  // namespace occlude::kernel
