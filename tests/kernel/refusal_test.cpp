// SPDX-License-Identifier: MIT
// Every reason for which the kernel refuses to build a frustum, decided exactly, next to input that is just legal.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>
#include <vector>

#include "kernel/cube.h"
#include "kernel/rounding.h"
#include "occlude/kernel/overlap.h"
#include "occlude/kernel/region_shadow.h"
#include "occlude/kernel/shadow_frustum.h"

namespace refusal_test {

using namespace occlude::kernel;
using Loop = std::vector<Vec3>;

Refusal refusal(const Viewpoint& viewpoint, const Loop& loop) {
  const Refusal farthest = ShadowFrustum::make(viewpoint, loop, Near::farthest).refusal;
  EXPECT_EQ(farthest, ShadowFrustum::make(viewpoint, loop, Near::surface).refusal);
  return farthest;
}

Refusal from_origin(const Loop& loop) { return refusal(Viewpoint::eye({0, 0, 0}), loop); }

constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

double up(double x) { return std::nextafter(x, kInfinity); }
double down(double x) { return std::nextafter(x, -kInfinity); }

/// Calls `try_number(x, refusal)` with numbers at the ends of the legal range and just beyond, and the expected refusals.
template <class TryNumber>
void try_numbers(const TryNumber& try_number) {
  for (const double sign : {1.0, -1.0}) {
    try_number(sign * kInfinity, Refusal::not_finite);
    try_number(sign * kNan, Refusal::not_finite);
    try_number(sign * 0x1p100, Refusal::none);
    try_number(sign * up(0x1p100), Refusal::out_of_range);
    try_number(sign * 0x1p-100, Refusal::none);
    try_number(sign * down(0x1p-100), Refusal::out_of_range);
    try_number(sign * std::numeric_limits<double>::denorm_min(), Refusal::out_of_range);
    try_number(sign * 0.0, Refusal::none);
  }
}

TEST(Refusal, NumbersOfPolygonsAndViewpoints) {
  for (int axis = 0; axis < 3; ++axis) {
    try_numbers([&](double x, Refusal expected) {
      // The loop is convex from the eye, and no line of sight runs along its plane, wherever on its axis the last vertex
      // goes.
      Loop loop{{2, 0, 0}, {2, 1, 0}, {2, 0, 1}};
      Vec3 far{-7, -9, -8}, along{1, 0.25, 0.25};
      far[axis] = x;
      along[axis] = x;
      const Refusal from_far = refusal(Viewpoint::eye(far), loop), along_it = refusal(Viewpoint::direction(along), loop);
      const bool is_in_plane = axis == 0 && x == 0;  // for the direction alone
      EXPECT_EQ(to_string(from_far), to_string(expected));
      EXPECT_EQ(to_string(along_it), to_string(is_in_plane ? Refusal::eye_in_plane : expected));
      if (expected == Refusal::none) return;
      loop[2][axis] = x;
      EXPECT_EQ(to_string(from_origin(loop)), to_string(expected));
    });
  }
  EXPECT_EQ(from_origin({{2, 0, 0}, {2, 0x1p100, 0}, {2, 0x1p-100, 1}}), Refusal::none);
}

TEST(Refusal, NumbersOfBoxes) {
  for (int axis = 0; axis < 3; ++axis) {
    try_numbers([&](double x, Refusal expected) {
      Aabb least{{-0x1p100, -0x1p100, -0x1p100}, {0x1p100, 0x1p100, 0x1p100}};
      Aabb most = least;
      least.min[axis] = x;
      most.max[axis] = x;
      EXPECT_EQ(check(least), expected);
      EXPECT_EQ(check(most), expected);
      Obb oriented{{1, 2, 3}, {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}};
      oriented.center[axis] = x;
      EXPECT_EQ(check(oriented), expected);
      for (std::size_t k = 0; k < 3; ++k) {
        Obb skew{{1, 2, 3}, {}};
        skew.half_edges[k][axis] = x;
        EXPECT_EQ(check(skew), expected);
      }
    });
  }
}

TEST(Refusal, MinAboveMax) {
  for (int axis = 0; axis < 3; ++axis) {
    Aabb box{{1, 1, 1}, {1, 1, 1}};
    EXPECT_EQ(check(box), Refusal::none);
    box.max[axis] = down(1);
    EXPECT_EQ(check(box), Refusal::min_above_max);
    box.min[axis] = down(1);
    EXPECT_EQ(check(box), Refusal::none);
  }
  EXPECT_EQ(check(Aabb{{0.0, 0, 0}, {-0.0, 0, 0}}), Refusal::none);
}

TEST(Refusal, FewerThanThreeDistinctVertices) {
  EXPECT_EQ(from_origin({}), Refusal::too_few_vertices);
  EXPECT_EQ(from_origin({{2, 0, 0}, {2, 1, 0}}), Refusal::too_few_vertices);
  EXPECT_EQ(from_origin({{2, 0, 0}, {2, 1, 0}, {2, 0, 0}, {2, 1, 0}}), Refusal::too_few_vertices);
  EXPECT_EQ(from_origin({{2, 0, 0}, {2, 1, 0}, {2, 1, -0.0}}), Refusal::too_few_vertices);
  EXPECT_EQ(from_origin({{2, 0, 0}, {2, 1, 0}, {2, 1, 0x1p-100}}), Refusal::none);
  EXPECT_EQ(from_origin({{2, 0, 3}, {2, 1, 3}, {2, 1, up(3)}}), Refusal::none);
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
  // The eye lies between the first vertex and the last. Seen from the eye, the last adds no turn, but it is behind the eye.
  EXPECT_EQ(from_origin({{2, -1, -1}, {2, 1, -1}, {2, 0, 1}, {-1, 0.5, 0.5}}), Refusal::not_convex);
}

TEST(Refusal, OneUlpOfConcavityIsSeen) {
  Loop loop{{2, -1, -1}, {2, 1, -1}, {2, 1, 1}, {2, 0, 1}, {2, -1, 1}};
  EXPECT_EQ(from_origin(loop), Refusal::none);
  loop[3].z = down(1);
  EXPECT_EQ(from_origin(loop), Refusal::not_convex);
  loop[3].z = up(1);
  EXPECT_EQ(from_origin(loop), Refusal::none);
}

TEST(Refusal, ViewpointInThePlane) {
  const Loop floor{{1, -1, 0}, {3, -1, 0}, {3, 1, 0}, {1, 1, 0}};
  EXPECT_EQ(from_origin(floor), Refusal::eye_in_plane);
  EXPECT_EQ(refusal(Viewpoint::eye({2, 0, 0}), floor), Refusal::eye_in_plane);
  EXPECT_EQ(refusal(Viewpoint::eye({1, -1, 0}), floor), Refusal::eye_in_plane);
  EXPECT_EQ(refusal(Viewpoint::eye({0, 0, 0x1p-100}), floor), Refusal::none);
  EXPECT_EQ(refusal(Viewpoint::direction({1, 0, 0}), floor), Refusal::eye_in_plane);
  EXPECT_EQ(refusal(Viewpoint::direction({1, 0, 0x1p-100}), floor), Refusal::none);
  const Loop raised{{1, -1, 1}, {3, -1, 1}, {3, 1, 1}, {1, 1, 1}};
  EXPECT_EQ(refusal(Viewpoint::eye({-5, 7, 1}), raised), Refusal::eye_in_plane);
  EXPECT_EQ(refusal(Viewpoint::eye({-5, 7, up(1)}), raised), Refusal::none);
  EXPECT_EQ(refusal(Viewpoint::eye({-5, 7, down(1)}), raised), Refusal::none);
  // The eye is at a vertex of a loop that is not flat; the other three vertices alone would be legal.
  const Loop folded{{2, -1, -1}, {2, 1, -1}, {3, 1, 1}, {2, -1, 1}};
  EXPECT_EQ(from_origin(folded), Refusal::none);
  for (const Vec3& v : folded) EXPECT_EQ(refusal(Viewpoint::eye(v), folded), Refusal::eye_in_plane);
}

TEST(Refusal, ZeroDirection) {
  const Loop loop{{2, 0, 0}, {2, 1, 0}, {2, 0, 1}};
  EXPECT_EQ(refusal(Viewpoint::direction({0, 0, 0}), loop), Refusal::zero_direction);
  EXPECT_EQ(refusal(Viewpoint::direction({0, -0.0, 0}), loop), Refusal::zero_direction);
  EXPECT_EQ(refusal(Viewpoint::direction({0x1p-100, 0, 0}), loop), Refusal::none);
}

/// The refusal of an input that must be refused for this reason.
Refusal example_of(Refusal reason) {
  const Loop triangle{{2, 0, 0}, {2, 1, 0}, {2, 0, 1}};
  const Polytope whole = occlude::cube({2, -1, -1});
  Polytope changed = whole;
  switch (reason) {
    case Refusal::none:
      return from_origin(triangle);
    case Refusal::not_finite:
      return check(Vec3{0, kNan, 0});
    case Refusal::out_of_range:
      return check(Vec3{0, 0, 1e31});
    case Refusal::min_above_max:
      return check(Aabb{{1, 0, 0}, {0, 1, 1}});
    case Refusal::too_few_vertices:
      return from_origin({{2, 0, 0}, {2, 1, 0}});
    case Refusal::not_convex:
      return from_origin({{2, 0, 0}, {2, 2, -1}, {2, 1, 0}, {2, 2, 1}});
    case Refusal::eye_in_plane:
      return refusal(Viewpoint::eye({2, 5, 5}), triangle);
    case Refusal::zero_direction:
      return refusal(Viewpoint::direction({0, 0, 0}), triangle);
    case Refusal::bad_face_index:
      changed.faces[0][0] = 8;
      return ConvexPolytope::make(changed).refusal;
    case Refusal::polytope_not_convex:
      changed.vertices[0].x = 3;
      return ConvexPolytope::make(changed).refusal;
    case Refusal::polytope_not_closed:
      changed.faces.pop_back();
      return ConvexPolytope::make(changed).refusal;
    case Refusal::eye_in_polytope:
      return ShadowFrustum::make(Viewpoint::eye({3, 0, 0}), *ConvexPolytope::make(whole).polytope, Near::surface).refusal;
    case Refusal::not_coplanar:
      return RegionShadow::make({}, std::vector<Vec3>{{2, 0, 0}, {2, 1, 0}, {3, 1, 1}, {2, 0, 1}}, ShadowKind::umbra)
          .refusal;
    case Refusal::rounding_mode: {
      const occlude::WithRounding upward(FE_UPWARD);
      return from_origin(triangle);
    }
  }
  return Refusal::none;
}

TEST(Refusal, EveryReasonHasAnExampleAndAText) {
  std::set<std::string_view> texts;
  constexpr int kReasons = static_cast<int>(Refusal::rounding_mode) + 1;
  for (int i = 0; i < kReasons; ++i) {
    const auto reason = static_cast<Refusal>(i);
    const bool has_example = reason != Refusal::rounding_mode || occlude::kHasOtherRoundings;
    if (has_example) {
      EXPECT_EQ(to_string(example_of(reason)), to_string(reason));
    }
    texts.insert(to_string(reason));
  }
  EXPECT_EQ(texts.size(), static_cast<std::size_t>(kReasons));
}

TEST(Silhouette, NeedlessVerticesAreDropped) {
  const Loop loop{{2, -1, -1}, {2, 0, -1}, {2, 1, -1}, {2, 1, -1}, {2, 1, 1}, {2, -1, 1}, {2, -1, 0.5}};
  const auto made = ShadowFrustum::make(Viewpoint::eye({0, 0, 0}), loop, Near::surface);
  ASSERT_TRUE(made.frustum);
  EXPECT_EQ(made.frustum->silhouette().size(), 4U);
}

/// A regular polygon on a circle at x = 2 round the x axis.
Loop disc(int sides) {
  Loop loop;
  for (int i = 0; i < sides; ++i) {
    const double angle = i * 2 * 3.14159265358979 / sides;
    loop.push_back({2, std::cos(angle), std::sin(angle)});
  }
  return loop;
}

/// So many vertices that work for every pair of them would take minutes.
constexpr int kVeryMany = 200000;

TEST(Silhouette, OfVeryManySides) {
  const Loop round = disc(kVeryMany);
  const auto made = ShadowFrustum::make(Viewpoint::eye({0, 0, 0}), round, Near::surface);
  ASSERT_TRUE(made.frustum);
  EXPECT_EQ(made.frustum->silhouette().size(), round.size());
  Loop dented = round;
  dented[kVeryMany - 2] = {2, 0.5, 0};
  EXPECT_EQ(from_origin(dented), Refusal::not_convex);
  Loop twice = round;
  twice.insert(twice.end(), round.begin(), round.end());
  EXPECT_EQ(from_origin(twice), Refusal::not_convex);
}

TEST(Silhouette, OfVeryManyNeedlessVertices) {
  Loop loop;
  for (int i = 0; i < kVeryMany; ++i) loop.push_back({2, -1 + i * 0x1p-17, -1});
  loop.push_back({2, 1, 1});
  for (int i = 0; i < kVeryMany; ++i) loop.push_back({2, -1, 1});
  const auto made = ShadowFrustum::make(Viewpoint::eye({0, 0, 0}), loop, Near::surface);
  ASSERT_TRUE(made.frustum);
  EXPECT_EQ(made.frustum->silhouette().size(), 4U);
}

/// The loop goes back and forth in a plane with the eye. Every dropped vertex makes the one before it drop in the next
/// round.
TEST(Silhouette, DroppedOneByOneFromTheEnd) {
  Loop loop;
  for (int i = 0; i < kVeryMany; ++i) loop.push_back(i % 2 == 0 ? Vec3{1, 0, 0} : Vec3{-1, 5, 0});
  loop.push_back({-2, -5, 0});
  EXPECT_EQ(from_origin(loop), Refusal::eye_in_plane);
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

TEST(SupportPlane, HasNoVertexBeyondItWhereverTheLoopBegins) {
  Loop bent{{2, -1, -1}, {2.5, 0, -1.5}, {2.75, 1, -1}, {2, 1, 1}, {2.25, 0, 1.5}, {2.5, -1, 1}};
  for (std::size_t i = 0; i < bent.size(); ++i) {
    const auto made = ShadowFrustum::make(Viewpoint::eye({0, 0, 0}), bent, Near::surface);
    ASSERT_TRUE(made.frustum && made.frustum->support_plane());
    for (const Vec3& v : bent) {
      EXPECT_NE(overlap_certified(*made.frustum, Aabb{v, v}, NearBoundary::open).relation, Relation::inside) << i;
    }
    std::rotate(bent.begin(), bent.begin() + 1, bent.end());
  }
}

TEST(SupportPlane, LiesBeyondTheEyeThatIsInThePlaneUpToRounding) {
  // x + 2y = z except for rounding, and only rounding gives the mean plane its side.
  const Loop flat{{0.8, -0.4, 0}, {0.5, 0.9, 2.3}, {0.1, 0.9, 1.9}, {0.2, 0.6, 1.4}};
  const Vec3 eye{0, 0, 0};
  const auto made = ShadowFrustum::make(Viewpoint::eye(eye), flat, Near::surface);
  ASSERT_TRUE(made.frustum && made.frustum->support_plane());
  EXPECT_EQ(overlap_certified(*made.frustum, Aabb{eye, eye}).relation, Relation::outside);
}

}  // namespace refusal_test
