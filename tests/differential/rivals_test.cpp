// SPDX-License-Identifier: MIT
// The rivals round like the arithmetics that they stand for.
#include "differential/rivals.h"

#include <gtest/gtest.h>

#include "occlude/fuzz/random.h"

namespace occlude::fuzz {
namespace rivals_test {

TEST(Float32, RoundsAsFloatsDo) {
  Random random(1);
  for (int i = 0; i < 10'000; ++i) {
    const auto a = static_cast<float>(random.real(-10, 10)), b = static_cast<float>(random.real(-1e-3, 10));
    EXPECT_EQ((Float32{a} * Float32{b}).value, static_cast<double>(a * b));
    EXPECT_EQ((Float32{a} + Float32{b}).value, static_cast<double>(a + b));
    EXPECT_EQ((Float32{a} - Float32{b}).value, static_cast<double>(a - b));
    const double x = random.real(-1, 1);
    EXPECT_EQ(Float32::rounded(x).value, static_cast<double>(static_cast<float>(x)));
  }
}

TEST(Fused, RoundsASumOfProductsAsProcessorsDo) {
  Random random(2);
  bool differs = false;
  for (int i = 0; i < 1000; ++i) {
    const double a = random.real(-1, 1), b = random.real(-1, 1), c = random.real(-1, 1), d = random.real(-1, 1);
    const Fused sum = Fused{a} * Fused{b} + Fused{c} * Fused{d};
    EXPECT_EQ(sum.value, std::fma(a, b, c * d));
    const Fused difference = Fused{a} * Fused{b} - Fused{c} * Fused{d};
    EXPECT_EQ(difference.value, std::fma(a, b, -(c * d)));
    const Fused more = Fused{c} + Fused{a} * Fused{b};
    EXPECT_EQ(more.value, std::fma(a, b, c));
    differs = differs || sum.value != a * b + c * d;
  }
  EXPECT_TRUE(differs);
}

}  // namespace rivals_test
}  // namespace occlude::fuzz
