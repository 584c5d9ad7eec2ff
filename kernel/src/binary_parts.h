// SPDX-License-Identifier: MIT
// A double as an integer times a power of two, for arithmetic in integers.
#pragma once

#include <bit>
#include <cstdint>

namespace occlude::kernel {

/// |x| = mantissa 2^exponent. REQUIRES: x is finite, not 0 and not subnormal, as every legal number but 0 is.
struct BinaryParts {
  static constexpr unsigned kMantissaBits = 53;

  explicit BinaryParts(double x) {
    constexpr std::uint64_t kLeading = std::uint64_t{1} << (kMantissaBits - 1);  // the bit that a double does not store
    constexpr unsigned kExponentMask = 0x7FF;
    constexpr int kBias = 1023 + kMantissaBits - 1;  // a mantissa stands for its 2^-52 part
    const auto bits = std::bit_cast<std::uint64_t>(x);
    mantissa = (bits & (kLeading - 1)) | kLeading;
    exponent = static_cast<int>(bits >> (kMantissaBits - 1) & kExponentMask) - kBias;
  }

  /// The exponent of the lowest bit: x 2^-lowest() is an odd integer.
  [[nodiscard]] int lowest() const { return exponent + std::countr_zero(mantissa); }
  /// The magnitude of that integer.
  [[nodiscard]] std::uint64_t odd() const { return mantissa >> static_cast<unsigned>(std::countr_zero(mantissa)); }

  std::uint64_t mantissa;
  int exponent;
};

}  // namespace occlude::kernel
