// SPDX-License-Identifier: MIT
// Doubles taken apart into an integer and a power of two.
#include "binary_parts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

namespace binary_parts_test {

using occlude::kernel::BinaryParts;

TEST(BinaryParts, LowestBitOfADouble) {
  EXPECT_EQ(BinaryParts(1).lowest(), 0);
  EXPECT_EQ(BinaryParts(-12).lowest(), 2);
  EXPECT_EQ(BinaryParts(0x1.8p-100).lowest(), -101);
  EXPECT_EQ(BinaryParts(0.1).lowest(), -55);
}

TEST(BinaryParts, AreTheNumber) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 10000; ++i) {
    const double x = std::ldexp(static_cast<double>(1 + random() % (std::uint64_t{1} << (1 + random() % 53))),
                                static_cast<int>(random() % 250) - 150);
    for (const double signed_x : {x, -x}) {
      const BinaryParts parts(signed_x);
      ASSERT_EQ(std::ldexp(static_cast<double>(parts.mantissa), parts.exponent), x);
      ASSERT_EQ(std::ldexp(static_cast<double>(parts.odd()), parts.lowest()), x);
      ASSERT_EQ(parts.odd() % 2, 1U);
    }
  }
}

}  // namespace binary_parts_test
