// SPDX-License-Identifier: MIT
// Points on planes and lines, and the next doubles on both sides.
#include "occlude/kernel/orientation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace occlude::kernel {
namespace orientation_test {

double above(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }
double below(double x) { return std::nextafter(x, -std::numeric_limits<double>::infinity()); }

TEST(Orientation, CounterClockwiseIsPositive) {
  EXPECT_EQ(orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
  EXPECT_EQ(orientation({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}), -1);
  EXPECT_EQ(orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {7, -5, 0}), 0);
  EXPECT_EQ(turn(2, {0, 0, 9}, {1, 0, -3}, {0, 1, 5}), 1);
  EXPECT_EQ(turn(0, {9, 0, 0}, {-3, 1, 0}, {5, 0, 1}), 1);
  EXPECT_EQ(turn(1, {0, 9, 0}, {0, -3, 1}, {1, 5, 0}), 1);
  EXPECT_EQ(turn(1, {0, 9, 0}, {1, 5, 0}, {0, -3, 1}), -1);
  EXPECT_EQ(turn(0, {1, 2, 3}, {4, 2, 3}, {5, 6, 7}), 0) << "a line that is seen as a point";
}

TEST(Orientation, ToTheNextDouble) {
  const Vec3 a{0.1, 0.2, 0.3}, b{0.7, 0.2, 0.3}, c{0.1, 0.9, 0.3};
  EXPECT_EQ(orientation(a, b, c, {0.4, 0.4, 0.3}), 0);
  EXPECT_EQ(orientation(a, b, c, {0.4, 0.4, above(0.3)}), 1);
  EXPECT_EQ(orientation(a, b, c, {0.4, 0.4, below(0.3)}), -1);
  const double third = 1.0 / 3;  // x = y, far from the origin and slanting
  const Vec3 from{third, third, 0}, to{0x1p60, 0x1p60, 5};
  EXPECT_EQ(turn(2, from, to, {0x1p50, 0x1p50, 1}), 0);
  EXPECT_EQ(turn(2, from, to, {0x1p50, above(0x1p50), 1}), 1);
  EXPECT_EQ(turn(2, from, to, {0x1p50, below(0x1p50), 1}), -1);
}

/// Small whole numbers, whose determinants 64 bits hold; scaled into the corners of the legal range.
TEST(Orientation, OfWholeNumbersAtEveryScale) {
  std::mt19937 random(1);
  const auto number = [&] { return static_cast<std::int64_t>(random() % 9) - 4; };
  for (int i = 0; i < 20000; ++i) {
    std::int64_t p[4][3];
    for (auto& point : p) {
      for (std::int64_t& x : point) x = number();
    }
    const auto d = [&](int j, int k) { return p[j][k] - p[0][k]; };
    const auto minor = [&](int axis) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      return d(1, u) * d(2, v) - d(1, v) * d(2, u);
    };
    const std::int64_t whole = minor(0) * d(3, 0) + minor(1) * d(3, 1) + minor(2) * d(3, 2);
    const auto sign = [](std::int64_t x) { return (x > 0) - (x < 0); };
    for (const double scale : {1.0, 0x1p-100, 0x1p97}) {
      const auto at = [&](int j) {
        const auto x = [&](int k) { return static_cast<double>(p[j][k]) * scale; };
        return Vec3{x(0), x(1), x(2)};
      };
      ASSERT_EQ(orientation(at(0), at(1), at(2), at(3)), sign(whole)) << i;
      for (int axis = 0; axis < 3; ++axis) ASSERT_EQ(turn(axis, at(0), at(1), at(2)), sign(minor(axis))) << i;
    }
  }
}

}  // namespace orientation_test
}  // namespace occlude::kernel
