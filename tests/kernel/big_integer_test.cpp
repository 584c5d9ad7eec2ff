// SPDX-License-Identifier: MIT
// Integers of any size against identities, and against floating-point numbers that hold them exactly.
#include "big_integer.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>

namespace big_integer_test {

using occlude::kernel::BigInteger;

bool is_equal(const BigInteger& a, const BigInteger& b) { return (a - b).sign() == 0; }

BigInteger some_number(std::mt19937_64& random) {
  const double mantissa = std::uniform_real_distribution<double>(-1, 1)(random);
  return BigInteger::scaled(mantissa, 60 + static_cast<int>(random() % 300)) +
         BigInteger(static_cast<int>(random() % 3) - 1);
}

TEST(BigInteger, SmallNumbersAndTheirSums) {
  constexpr std::int64_t k31 = std::int64_t{1} << 31U, k62 = std::int64_t{1} << 62U;
  constexpr std::array<std::int64_t, 8> kLeft{-3, 0, 7, k31 - 1, k31, -k31, k62 - 1, k62};
  constexpr std::array<std::int64_t, 6> kRight{-1, 0, 2, k31, -k62, k62 + 1};
  for (const std::int64_t a : kLeft) {
    for (const std::int64_t b : kRight) {
      const auto exactly = [](std::int64_t x) {
        return BigInteger::scaled(static_cast<double>(x >> 32U), 32) + BigInteger(x & 0xffffffff);
      };
      EXPECT_TRUE(is_equal(BigInteger(a), exactly(a))) << a;
      EXPECT_TRUE(is_equal(BigInteger(a) + BigInteger(b), exactly(a) + exactly(b))) << a << ' ' << b;
      EXPECT_TRUE(is_equal(BigInteger(a) * BigInteger(b), exactly(a) * exactly(b))) << a << ' ' << b;
      EXPECT_EQ((BigInteger(a) - BigInteger(b)).sign(), (a > b) - (a < b)) << a << ' ' << b;
      EXPECT_EQ((BigInteger(a) * BigInteger(b)).sign(), ((a > 0) - (a < 0)) * ((b > 0) - (b < 0))) << a << ' ' << b;
    }
  }
}

TEST(BigInteger, SumsAndProductsOfAnySizeAreExact) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const BigInteger a = some_number(random), b = some_number(random), c = some_number(random);
    ASSERT_TRUE(is_equal((a + b) * (a - b), a * a - b * b));
    ASSERT_TRUE(is_equal((a + b) * c, a * c + b * c));
    ASSERT_TRUE(is_equal((a + b) + c, a + (b + c)));
    ASSERT_TRUE(is_equal(-(-a), a));
    ASSERT_EQ((a * b).sign(), a.sign() * b.sign());
    ASSERT_FALSE(is_equal(a, a + BigInteger(1)));
    ASSERT_EQ((a + BigInteger(1) - a).sign(), 1);
  }
}

/// Products and sums that a long double holds exactly.
TEST(BigInteger, AgreesWithFloatingPointWhereThatIsExact) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 20000; ++i) {
    const auto part = [&] { return static_cast<double>(static_cast<std::int64_t>(random() >> 34U) - (1 << 29U)); };
    const double a = part(), b = part(), c = part(), d = part();
    const long double determinant = static_cast<long double>(a) * d - static_cast<long double>(b) * c;
    const BigInteger exactly =
        BigInteger::scaled(a, 3) * BigInteger::scaled(d, 97) - BigInteger::scaled(b, 50) * BigInteger::scaled(c, 50);
    ASSERT_EQ(exactly.sign(), (determinant > 0) - (determinant < 0));
  }
}

}  // namespace big_integer_test
