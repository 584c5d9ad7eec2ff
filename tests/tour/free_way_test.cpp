// SPDX-License-Identifier: MIT
// A way that a triangle touches is not free, and one that passes it at a distance is.
#include "free_way.h"

#include <gtest/gtest.h>

#include <array>

namespace occlude::render {
namespace free_way_test {

using glm::dvec3;

/// The triangle (0, 0, 0), (8, 0, 0), (0, 8, 0).
culler::PolygonSoup triangle() {
  culler::PolygonSoup soup;
  soup.add_polygon(std::array{soup.add_vertex({0, 0, 0}), soup.add_vertex({8, 0, 0}), soup.add_vertex({0, 8, 0})});
  return soup;
}

bool is_free(const dvec3& from, const dvec3& to, double clearance) {
  const std::array<CameraPath::Keyframe, 2> way{{{from, from + 1.0}, {to, to + 1.0}}};
  return is_free_way(triangle(), way, clearance);
}

TEST(FreeWay, MeetsNoTriangle) {
  constexpr double kHair = 0x1p-30;
  EXPECT_FALSE(is_free({2, 2, -5}, {2, 2, 5}, kHair)) << "through the middle";
  EXPECT_FALSE(is_free({2, 2, 0}, {2, 2, 5}, kHair)) << "from the middle";
  EXPECT_FALSE(is_free({0, 0, -5}, {0, 0, 5}, kHair)) << "through a corner";
  EXPECT_FALSE(is_free({4, 4, -5}, {4, 4, 5}, kHair)) << "through an edge";
  EXPECT_FALSE(is_free({-5, 1, 0}, {20, 1, 0}, kHair)) << "in its plane, across";
  EXPECT_FALSE(is_free({1, 1, 0}, {2, 1, 0}, kHair)) << "in its plane, within";
  EXPECT_FALSE(is_free({0, -5, 0}, {0, 20, 0}, kHair)) << "along an edge";
  EXPECT_FALSE(is_free({2, 2, 0}, {2, 2, 0}, kHair)) << "a point of it";
  EXPECT_TRUE(is_free({4.001, 4.001, -5}, {4.001, 4.001, 5}, kHair)) << "beside an edge";
  EXPECT_TRUE(is_free({2, 2, 0x1p-20}, {2, 2, 5}, kHair)) << "from above";
  EXPECT_TRUE(is_free({-5, -1, 0}, {20, -1, 0}, kHair)) << "in its plane, beside";
}

TEST(FreeWay, KeepsItsDistance) {
  EXPECT_TRUE(is_free({2, 2, 1.01}, {3, 3, 4}, 1));
  EXPECT_FALSE(is_free({2, 2, 0.99}, {3, 3, 4}, 1));
  EXPECT_TRUE(is_free({-5, -1.01, 0}, {5, -1.01, 0}, 1));
  EXPECT_FALSE(is_free({-5, -0.99, 0}, {5, -0.99, 0}, 1));
  EXPECT_TRUE(is_free({4, -2, -0.8}, {4, 2, 2.2}, 0.5)) << "0.56 from an edge";
  EXPECT_FALSE(is_free({4, -2, -0.8}, {4, 2, 2.2}, 0.6));
}

TEST(FreeWay, DoubtsWhatIsRoundedAway) {
  const std::array<CameraPath::Keyframe, 1> way{{{dvec3(0x1p60), dvec3(0)}}};
  EXPECT_FALSE(is_free_way(triangle(), way, 1));
  EXPECT_TRUE(is_free_way(triangle(), way, 0x1p21));
}

}  // namespace free_way_test
}  // namespace occlude::render
