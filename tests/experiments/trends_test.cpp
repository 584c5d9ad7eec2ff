// SPDX-License-Identifier: MIT
#include "trends.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace trends_test {

using namespace occlude::experiments;

TEST(Knee, IsTheFirstThatReachesNineTenthsOfTheLast) {
  EXPECT_EQ(knee(std::array{0.1, 0.5, 0.89, 0.9, 1.0}), 3U);
  EXPECT_EQ(knee(std::array{0.1, 0.5, 0.8, 0.85, 1.0}), 4U);
  EXPECT_EQ(knee(std::array{0.95, 0.96, 1.0}), 0U);
}

TEST(Knee, OfACurveThatFallsAtTheEndIsItsFirstThatIsAsGood) { EXPECT_EQ(knee(std::array{0.2, 0.8, 0.6}), 1U); }

TEST(Knee, OfNothingIsAtTheStart) {
  EXPECT_EQ(knee(std::array{0.0, 0.0, 0.0}), 0U);
  EXPECT_EQ(knee(std::array{0.3}), 0U);
}

TEST(FittedExponent, IsThatOfAPowerLaw) {
  std::vector<double> x, y, falling;
  for (const double value : {1e4, 2e4, 5e4, 1e5, 1e6}) {
    x.push_back(value);
    y.push_back(3e-7 * std::pow(value, 1.5));
    falling.push_back(1 / value);
  }
  EXPECT_NEAR(*fitted_exponent(x, y), 1.5, 1e-12);
  EXPECT_NEAR(*fitted_exponent(x, falling), -1, 1e-12);
}

/// Points that lie above and below a line by a factor of 2 give that line.
TEST(FittedExponent, IsTheBestByLeastSquares) {
  EXPECT_NEAR(*fitted_exponent(std::array{1.0, 1.0, 100.0, 100.0}, std::array{0.5, 2.0, 50.0, 200.0}), 1, 1e-12);
}

TEST(FittedExponent, NeedsTwoDifferentSizes) {
  EXPECT_FALSE(fitted_exponent({}, {}));
  EXPECT_FALSE(fitted_exponent(std::array{5.0}, std::array{7.0}));
  EXPECT_FALSE(fitted_exponent(std::array{5.0, 5.0}, std::array{7.0, 9.0}));
}

}  // namespace trends_test
