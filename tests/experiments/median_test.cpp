// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "bench.h"

namespace median_test {

using namespace occlude::bench;

TEST(Median, IsTheMiddleOrTheMeanOfTheTwoInTheMiddle) {
  EXPECT_EQ(median({4, 1, 2}), 2);
  EXPECT_EQ(median({8, 1, 2, 4}), 3);
}

/// The ratio of the medians would be 4 and 0.25.
TEST(Median, OfRatiosIsOfTheRounds) {
  EXPECT_EQ(median_ratio({1, 8, 16}, {2, 1, 8}), 2);
  EXPECT_EQ(median_ratio({2, 1, 8}, {1, 8, 16}), 0.5);
}

}  // namespace median_test
