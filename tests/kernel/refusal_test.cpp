// SPDX-License-Identifier: MIT
// Every reason for which the kernel builds no frustum, decided exactly, and what is legal right beside it.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "occlude/kernel/shadow_frustum.h"

namespace {

using namespace occlude::kernel;
using Loop = std::vector<Vec3>;

Refusal refusal(const Viewpoint& viewpoint, const Loop& loop) {
  const Refusal farthest = ShadowFrustum::make(viewpoint, loop, Near::farthest).refusal;
  EXPECT_EQ(farthest, ShadowFrustum::make(viewpoint, loop, Near::surface).refusal);
  return farthest;
}

Refusal from_origin(const Loop& loop) { return refusal(Viewpoint::eye({0, 0, 0}), loop); }

constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

TEST(Refusal, NumbersThatAreNotFinite) {
  EXPECT_EQ(from_origin({{2, kNan, 0}, {2, 1, 0}, {2, 0, 1}}), Refusal::not_finite);
  EXPECT_EQ(from_origin({{2, 0, 0}, {2, kInfinity, 0}, {2, 0, 1}}), Refusal::not_finite);
  EXPECT_EQ(refusal(Viewpoint::eye({0, -kInfinity, 0}), {{2, 0, 0}, {2, 1, 0}, {2, 0, 1}}), Refusal::not_finite);
}

TEST(Refusal, NumbersOutOfRange) {
  EXPECT_EQ(from_origin({{2, 0, 0}, {2, 0x1.8p100, 0}, {2, 0, 1}}), Refusal::out_of_range);
  EXPECT_EQ(from_origin({{2, 0, 0}, {2, 1, 0x1p-101}, {2, 0, 1}}), Refusal::out_of_range);
  EXPECT_EQ(from_origin({{2, 0, 0}, {2, 0x1p100, 0}, {2, 0x1p-100, 1}}), Refusal::none);
}

TEST(Refusal, Boxes) {
  EXPECT_EQ(check(Aabb{{0, 0, 0}, {1, 1, 1}}), Refusal::none);
  EXPECT_EQ(check(Aabb{{0, 0, 0}, {0, 0, 0}}), Refusal::none);
  EXPECT_EQ(check(Aabb{{0, 2, 0}, {1, 1, 1}}), Refusal::min_above_max);
  EXPECT_EQ(check(Aabb{{0, kNan, 0}, {1, 1, 1}}), Refusal::not_finite);
  EXPECT_EQ(check(Aabb{{0, 0, 0}, {1, 1, 1e40}}), Refusal::out_of_range);
}

TEST(Refusal, FewerThanThreeDistinctVertices) {
  EXPECT_EQ(from_origin({}), Refusal::too_few_vertices);
  EXPECT_EQ(from_origin({{2, 0, 0}, {2, 1, 0}}), Refusal::too_few_vertices);
  EXPECT_EQ(from_origin({{2, 0, 0}, {2, 1, 0}, {2, 0, 0}, {2, 1, 0}}), Refusal::too_few_vertices);
}

TEST(Refusal, LoopsThatAreNotConvexFromHere) {
  const Loop dart{{2, 0, 0}, {2, 2, -1}, {2, 1, 0}, {2, 2, 1}};
  EXPECT_EQ(from_origin(dart), Refusal::not_convex);
  const Loop bow_tie{{2, -1, -1}, {2, 1, 1}, {2, 1, -1}, {2, -1, 1}};
  EXPECT_EQ(from_origin(bow_tie), Refusal::not_convex);
  Loop star;
  for (int i = 0; i < 5; ++i) star.push_back({2, std::cos(i * 2 * 1.2566), std::sin(i * 2 * 1.2566)});
  EXPECT_EQ(from_origin(star), Refusal::not_convex);
  const Loop twice{{2, -1, -1}, {2, 1, -1}, {2, 0, 1}, {2, -1, -1}, {2, 1, -1}, {2, 0, 1}};
  EXPECT_EQ(from_origin(twice), Refusal::not_convex);
  const Loop spike{{2, -1, -1}, {2, 1, -1}, {2, 2, -1}, {2, 1, -1}, {2, 0, 1}};
  EXPECT_EQ(from_origin(spike), Refusal::not_convex);
}

TEST(Refusal, LoopsFoldedThroughTheEye) {
  // The eye lies between the first vertex and the last: seen from it the last adds no turn, and yet it is behind.
  EXPECT_EQ(from_origin({{2, -1, -1}, {2, 1, -1}, {2, 0, 1}, {-1, 0.5, 0.5}}), Refusal::not_convex);
}

TEST(Refusal, OneUlpOfConcavityIsSeen) {
  Loop loop{{2, -1, -1}, {2, 1, -1}, {2, 1, 1}, {2, 0, 1}, {2, -1, 1}};
  EXPECT_EQ(from_origin(loop), Refusal::none);
  loop[3].z = std::nextafter(1.0, 0.0);
  EXPECT_EQ(from_origin(loop), Refusal::not_convex);
}

TEST(Refusal, ViewpointInThePlane) {
  const Loop floor{{1, -1, 0}, {3, -1, 0}, {3, 1, 0}, {1, 1, 0}};
  EXPECT_EQ(from_origin(floor), Refusal::eye_in_plane);
  EXPECT_EQ(refusal(Viewpoint::eye({2, 0, 0}), floor), Refusal::eye_in_plane);
  EXPECT_EQ(refusal(Viewpoint::eye({1, -1, 0}), floor), Refusal::eye_in_plane);
  EXPECT_EQ(refusal(Viewpoint::eye({0, 0, 0x1p-100}), floor), Refusal::none);
  EXPECT_EQ(refusal(Viewpoint::direction({1, 0, 0}), floor), Refusal::eye_in_plane);
  EXPECT_EQ(refusal(Viewpoint::direction({1, 0, 0x1p-100}), floor), Refusal::none);
}

TEST(Refusal, ZeroDirection) {
  EXPECT_EQ(refusal(Viewpoint::direction({0, 0, 0}), {{2, 0, 0}, {2, 1, 0}, {2, 0, 1}}), Refusal::zero_direction);
}

TEST(Silhouette, NeedlessVerticesAreDropped) {
  const Loop loop{{2, -1, -1}, {2, 0, -1}, {2, 1, -1}, {2, 1, -1}, {2, 1, 1}, {2, -1, 1}, {2, -1, 0.5}};
  const auto made = ShadowFrustum::make(Viewpoint::eye({0, 0, 0}), loop, Near::surface);
  ASSERT_TRUE(made.frustum);
  EXPECT_EQ(made.frustum->silhouette().size(), 4U);
}

TEST(SupportPlane, LiesBehindAPolygonThatIsNotFlat) {
  const Loop bent{{2, -1, -1}, {2.5, 1, -1}, {2, 1, 1}, {2.25, -1, 1}};
  const auto made = ShadowFrustum::make(Viewpoint::eye({0, 0, 0}), bent, Near::surface);
  ASSERT_TRUE(made.frustum && made.frustum->support_plane());
  const auto& [n, p] = *made.frustum->support_plane();
  const auto dot = [](const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
  for (const Vec3& v : bent) EXPECT_LE(dot(n, v), dot(n, p));
  EXPECT_GT(dot(n, p), 0);
}

}  // namespace
