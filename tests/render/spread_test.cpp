// SPDX-License-Identifier: MIT
#include "occlude/render/spread.h"

#include <gtest/gtest.h>

#include <limits>

namespace occlude::render {
namespace spread_test {

TEST(Spread, InterpolatesBetweenValues) {
  EXPECT_EQ(quantile({7}, 0.05), 7);
  EXPECT_EQ(quantile({1, 2}, 0.5), 1.5);
  EXPECT_EQ(quantile({1, 2, 4}, 0.5), 2);
  EXPECT_EQ(quantile({1, 2, 4}, 1), 4);
  EXPECT_NEAR(quantile({0, 10, 20}, 0.05), 1, 1e-12);
}

TEST(Spread, NamesTheWorstFrame) {
  const std::vector<FrameValue> values{{10, 3}, {11, 1}, {12, 9}};
  EXPECT_EQ(spread_of(values, Worst::most)->worst.frame, 12U);
  EXPECT_EQ(spread_of(values, Worst::least)->worst.frame, 11U);
  EXPECT_EQ(spread_of(values, Worst::least)->median, 3);
}

TEST(Spread, LeavesOutWhatIsNotFinite) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto spread = spread_of({{0, kInfinity}, {1, 2}, {2, kInfinity - kInfinity}}, Worst::most);
  ASSERT_TRUE(spread);
  EXPECT_EQ(spread->worst.value, 2);
  EXPECT_FALSE(spread_of({{0, kInfinity}}, Worst::most));
  EXPECT_FALSE(spread_of({}, Worst::most));
}

}  // namespace spread_test
}  // namespace occlude::render
