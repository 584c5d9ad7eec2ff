// SPDX-License-Identifier: MIT
// Triangles that touch are never apart; those that a plane divides are.
#include "simplify/triangles_apart.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "model/bounds.h"
#include "seed.h"

namespace triangles_apart_test {

using namespace occlude::culler;
using glm::dvec3;

SolidTriangle triangle(const std::array<dvec3, 3>& corners) {
  SolidTriangle result{{}, empty_box()};
  for (std::size_t i = 0; i < 3; ++i) {
    result.corners[i] = to_kernel(corners[i]);
    grow(result.box, result.corners[i]);
  }
  return result;
}

TEST(TrianglesApart, ByAnUlp) {
  const std::array<dvec3, 3> floor{dvec3(0, 0, 0), {8, 0, 0}, {0, 8, 0}};
  const auto is_apart = [&](const std::array<dvec3, 3>& other) {
    const bool answer = are_apart(triangle(floor), triangle(other));
    EXPECT_EQ(are_apart(triangle(other), triangle(floor)), answer);
    return answer;
  };
  constexpr double kAbove = 0x1p-100;
  for (const double z : {0.0, kAbove}) {
    EXPECT_EQ(is_apart({dvec3(2, 2, z), {3, 2, 5}, {2, 3, 5}}), z > 0) << "a corner on the face";
    EXPECT_EQ(is_apart({dvec3(-1, 1, z), {1, -1, z}, {0, 0, 5}}), z > 0) << "a side on the corner";
    EXPECT_EQ(is_apart({dvec3(1, 1, z), {1, 2, z}, {2, 1, z}}), z > 0) << "in its plane";
  }
  EXPECT_FALSE(is_apart({dvec3(2, 2, -1), {3, 2, 5}, {2, 3, 5}})) << "a corner beyond";
  EXPECT_FALSE(is_apart({dvec3(2, 2, -1), {3, 2, -1}, {2, 3, 5}})) << "two";
  EXPECT_FALSE(is_apart({dvec3(2, -9, -9), {2, 9, -9}, {2, 0, 9}})) << "a side through the other";
  EXPECT_FALSE(is_apart(floor));
  // A side passes a side.
  EXPECT_FALSE(is_apart({dvec3(4, 4, -1), {4, 4, 1}, {9, 9, 0}}));
  EXPECT_TRUE(is_apart({dvec3(4, std::nextafter(4, 5), -1), {4, std::nextafter(4, 5), 1}, {9, 9, 0.5}}));
}

TEST(TrianglesApart, NeverWithAPointInCommonAndMostlyWithAPlaneBetween) {
  std::mt19937 random(occlude::seed_of(1));
  const auto whole = [&](int most) { return static_cast<int>(random() % static_cast<unsigned>(2 * most + 1)) - most; };
  const auto point = [&] { return dvec3(whole(6), whole(6), whole(6)); };
  int apart = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::array<dvec3, 3> a{point(), point(), point()}, b{point(), point(), point()};
    // Points of both with whole coordinates, once they are six times as large.
    const auto some_point = [&](const std::array<dvec3, 3>& t) {
      const int u = static_cast<int>(random() % 7), v = static_cast<int>(random() % static_cast<unsigned>(7 - u));
      return static_cast<double>(u) * t[0] + static_cast<double>(v) * t[1] + static_cast<double>(6 - u - v) * t[2];
    };
    const dvec3 move = some_point(a) - some_point(b);
    std::array<dvec3, 3> touching, beyond;
    const dvec3 normal(whole(3), whole(3), 1 + std::abs(whole(3)));
    double highest = -HUGE_VAL, lowest = HUGE_VAL;
    for (std::size_t k = 0; k < 3; ++k) {
      a[k] *= 6;
      touching[k] = 6.0 * b[k] + move;
      highest = std::max(highest, glm::dot(normal, a[k]));
      lowest = std::min(lowest, glm::dot(normal, 6.0 * b[k]));
    }
    EXPECT_FALSE(are_apart(triangle(a), triangle(touching))) << i;
    const double up = std::ceil((highest - lowest) / normal.z) + 1;
    for (std::size_t k = 0; k < 3; ++k) beyond[k] = 6.0 * b[k] + dvec3(0, 0, up);
    apart += are_apart(triangle(a), triangle(beyond)) ? 1 : 0;
  }
  EXPECT_GT(apart, 19'000);
}

}  // namespace triangles_apart_test
