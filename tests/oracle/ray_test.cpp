// SPDX-License-Identifier: MIT
// Single rays: a table of what touches, and the lines of sight of sight.h, which are decided apart from them.
#include "occlude/oracle/ray.h"

#include <gtest/gtest.h>

#include <vector>

#include "occlude/fuzz/random.h"
#include "occlude/oracle/sight.h"
#include "seed.h"

namespace occlude::oracle {
namespace ray_test {

const Triangle kTriangle{{{2, 0, 0}, {2, 4, 0}, {2, 0, 4}}};
const std::vector<HalfSpaceCoefficients> kAll;
const HalfSpaceCoefficients kAhead{1, 0, 0, 0};  // x >= 0

Ray from_origin(const Point& through) { return {Viewpoint{{0, 0, 0}}, through}; }
Ray along_x(const Point& through) { return {Viewpoint{{1, 0, 0}, true}, through}; }

/// The triangle at x, larger by as much as it is farther.
Triangle at(double x) { return {{{x, 0, 0}, {x, 2 * x, 0}, {x, 0, 2 * x}}}; }

TEST(Ray, EntersATriangleWithinItsBorders) {
  for (const double scale : {0.25, 1.0, 1024.0}) {
    const auto enters = [&](double y, double z) {
      return from_origin({2 * scale, y * scale, z * scale}).enters(kTriangle, kAll);
    };
    EXPECT_TRUE(enters(1, 1));
    EXPECT_TRUE(enters(0x1p-40, 0x1p-40));
    EXPECT_FALSE(enters(0, 1));
    EXPECT_FALSE(enters(2, 2));
    EXPECT_FALSE(enters(0, 0));
    EXPECT_FALSE(enters(3, 3));
  }
  EXPECT_FALSE(from_origin({-2, -1, -1}).enters(kTriangle, kAll));  // behind the eye
  EXPECT_FALSE(from_origin({2, -1, -1}).enters(kTriangle, kAll));
  EXPECT_TRUE(along_x({9, 1, 1}).enters(kTriangle, kAll));
  EXPECT_TRUE(along_x({-9, 1, 1}).enters(kTriangle, kAll));
  EXPECT_FALSE(along_x({0, 0, 1}).enters(kTriangle, kAll));
}

TEST(Ray, EntersATriangleInsideOfAllHalfSpaces) {
  const auto enters = [](double x) {
    const std::vector<HalfSpaceCoefficients> within{kAhead, {1, 0, 0, -x}};
    return from_origin({1, 0.5, 0.5}).enters(kTriangle, within) && along_x({1, 1, 1}).enters(kTriangle, within);
  };
  EXPECT_TRUE(enters(1));
  EXPECT_TRUE(enters(2 - 0x1p-50));
  EXPECT_FALSE(enters(2));
  EXPECT_FALSE(enters(3));
}

TEST(Ray, OrdersWhatItMeets) {
  using enum Ray::Order;
  const auto order = [](const Triangle& other, const HalfSpaceCoefficients& drawn = kAhead) {
    const Ray::Order eye = from_origin({2, 1, 1}).order(kTriangle, other, drawn);
    const Ray::Order direction = along_x({7, 1, 1}).order(kTriangle, other, drawn);
    EXPECT_EQ(eye, direction);
    return eye;
  };
  EXPECT_EQ(order(at(1.5)), nearer);
  EXPECT_EQ(order(at(2 - 0x1p-51)), nearer);
  EXPECT_EQ(order(at(2)), same);
  EXPECT_EQ(order(at(2 + 0x1p-51)), farther);
  EXPECT_EQ(order({{{1.5, 2, 2}, {1.5, 4, 2}, {1.5, 2, 4}}}), apart);
  EXPECT_EQ(order(at(-1)), apart);
  EXPECT_EQ(order(at(1.5), {1, 0, 0, -1.5}), nearer);
  EXPECT_EQ(order(at(1.5), {1, 0, 0, -1.5 - 0x1p-51}), apart);
  EXPECT_EQ(order({{{1.5, 1, 1}, {1.5, 1, 1}, {1.5, 2, 2}}}), apart);  // without area
}

TEST(Ray, MeetsTheBordersOfWhatHides) {
  using enum Ray::Order;
  const auto order = [](const Triangle& other) { return along_x({0, 1, 1}).order(kTriangle, other, kAhead); };
  EXPECT_EQ(order({{{1, 1, 1}, {1, 2, 1}, {1, 1, 2}}}), nearer);  // a corner
  EXPECT_EQ(order({{{1, 0, 1}, {1, 2, 1}, {1, 1, 2}}}), nearer);  // an edge
  EXPECT_EQ(order({{{1, 0, 1}, {3, 2, 1}, {5, 0, 1}}}), nearer);  // in its plane
  EXPECT_EQ(order({{{1, 1, 1 + 0x1p-50}, {1, 2, 1}, {1, 1, 2}}}), apart);
}

// Sight knows whether something is strictly between two points. Of a ray to a point on a triangle that is parallel to an
// axis, both say the same.
TEST(Ray, AgreesWithSight) {
  const auto seed = seed_of(1);
  fuzz::Random random(seed);
  std::size_t nearer = 0;
  for (int i = 0; i < 20000; ++i) {
    const Triangle target{{{8, -16, -16}, {8, 32, -16}, {8, -16, 32}}};
    Triangle other{};
    for (Point& corner : other)
      corner = {random.integer(0, 9) * 1.0, random.integer(0, 7) * 1.0, random.integer(0, 7) * 1.0};
    const Point end{8, random.integer(1, 6) * 1.0, random.integer(1, 6) * 1.0};
    const Point eye{random.integer(0, 1) * 1.0, random.integer(0, 3) * 1.0, random.integer(0, 3) * 1.0};
    const Ray ray(Viewpoint{eye}, end);
    ASSERT_TRUE(ray.enters(target, kAll));
    const bool is_nearer = ray.order(target, other, {0, 0, 0, 1}) == Ray::Order::nearer;
    // Sight has only what is strictly between; so has order(), but for what lies in a plane with the ray.
    EXPECT_EQ(is_nearer, !Sight(std::vector{other}).is_clear(eye, end)) << "seed " << seed << ", case " << i;
    nearer += is_nearer;
  }
  EXPECT_GT(nearer, 1000U);
}

}  // namespace ray_test
}  // namespace occlude::oracle
