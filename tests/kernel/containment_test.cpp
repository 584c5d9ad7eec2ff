// SPDX-License-Identifier: MIT
// Points on the faces of oriented boxes, just inside them and just outside.
#include "occlude/kernel/containment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace occlude::kernel {
namespace containment_test {

double above(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }
double below(double x) { return std::nextafter(x, -std::numeric_limits<double>::infinity()); }

TEST(Containment, CornersFacesAndTheNextDouble) {
  const Obb turned{{10, 20, 30}, {{{3, 4, 0}, {-4, 3, 0}, {0, 0, 5}}}};
  EXPECT_TRUE(contains(turned, {10, 20, 30}));
  EXPECT_TRUE(contains(turned, {10 + 3 - 4, 20 + 4 + 3, 35}));
  EXPECT_TRUE(contains(turned, {10 - 3 + 4, 20 - 4 - 3, 25}));
  EXPECT_FALSE(contains(turned, {9, 27, above(35)}));
  EXPECT_TRUE(contains(turned, {9, below(27), 35}));
  EXPECT_FALSE(contains(turned, {9, above(27), 35}));
  EXPECT_FALSE(contains(turned, {below(9), 27, 35}));
  EXPECT_FALSE(contains(turned, {above(9), 27, 35}));
}

TEST(Containment, SkewAndTurnedInsideOut) {
  const Obb skew{{0, 0, 0}, {{{1, 0, 0}, {0.5, 1, 0}, {0.25, 0.25, 1}}}};
  EXPECT_TRUE(contains(skew, {1.75, 1.25, 1}));
  EXPECT_FALSE(contains(skew, {above(1.75), 1.25, 1}));
  EXPECT_FALSE(contains(skew, {-1.75, 1.25, 1}));
  const Obb turned_inside_out{skew.center, {skew.half_edges[1], skew.half_edges[0], skew.half_edges[2]}};
  EXPECT_TRUE(contains(turned_inside_out, {1.75, 1.25, 1}));
}

TEST(Containment, FarThinAndTiny) {
  const double far = 0x1p40, thin = 0x1p-12;  // an ulp of the far coordinates
  const Obb wall{{far, far, 0}, {{{1, 1, 0}, {-thin, thin, 0}, {0, 0, 1}}}};
  EXPECT_TRUE(contains(wall, {far + 1, far + 1, 0}));
  EXPECT_TRUE(contains(wall, {far - thin, far + thin, 1}));
  EXPECT_FALSE(contains(wall, {far - 2 * thin, far + thin, 1}));
  const double tiny = 0x1p-100;
  const Obb least{{0, 0, 0}, {{{tiny, 0, 0}, {0, tiny, 0}, {0, 0, tiny}}}};
  EXPECT_TRUE(contains(least, {tiny, -tiny, tiny}));
  EXPECT_FALSE(contains(least, {above(tiny), 0, 0}));
}

TEST(Containment, NeverInAFlatBox) {
  EXPECT_FALSE(contains({{0, 0, 0}, {{{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}}, {0, 0, 0}));
  EXPECT_FALSE(contains({}, {}));
}

}  // namespace containment_test
}  // namespace occlude::kernel
