// SPDX-License-Identifier: MIT
// Planes in floats, and what they may be off by.
#include "coarse_plane.h"

#include <gtest/gtest.h>

#include <cmath>

#include "error_bounds.h"

namespace coarse_plane_test {

using namespace occlude::kernel;

FilterPlane plane(double normal, double offset) {
  return {.normal = {normal, 0, 0}, .magnitudes = {std::fabs(normal), 0, 0}, .offset = offset, .farther = {}};
}

TEST(CoarsePlane, TheBoundIsFourTimesThatOfDoublesAtLeast) {
  CoarseBound bound;
  const CoarsePlane rounded = coarse(plane(-3, 5), {.slope = 8, .base = 16}, bound);
  EXPECT_EQ(rounded.x, -3);
  EXPECT_EQ(rounded.twice_offset, 10);
  EXPECT_GT(bound.slope, 4 * 8);
  EXPECT_GT(bound.twice_base, 2 * 4 * 16);
}

TEST(CoarsePlane, TheBoundHoldsForAllPlanes) {
  CoarseBound bound;
  EXPECT_EQ(coarse(plane(0x1p50, 0x1p60), {.slope = 1, .base = 1}, bound).x, 0x1p50);
  EXPECT_GT(bound.slope, 8 * 0x1p26);
  EXPECT_GT(bound.twice_base, 8 * 0x1p36);
  const CoarseBound before = bound;
  EXPECT_EQ(coarse(plane(1, 1), {.slope = 1, .base = 1}, bound).x, 1);
  EXPECT_EQ(bound, before);
}

TEST(CoarsePlane, APlaneBeyondFloatsDecidesNothing) {
  for (const double offset : {kCoarseOffset, -kCoarseOffset, HUGE_VAL, std::nan("")}) {
    CoarseBound bound;
    EXPECT_EQ(coarse(plane(1, offset), {.slope = 1, .base = 1}, bound), CoarsePlane());
    EXPECT_TRUE(std::isinf(bound.twice_base));
  }
}

}  // namespace coarse_plane_test
