// SPDX-License-Identifier: MIT
// Degenerate positions worked out by hand: the answer, and the cheapest stage that can give it.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "occlude/kernel/overlap.h"

namespace {

using namespace occlude::kernel;

/// A square wall at x = 2 from (-1, -1) to (1, 1), seen from the origin: its shadow widens by half the depth.
const std::vector<Vec3> kWall{{2, -1, -1}, {2, 1, -1}, {2, 1, 1}, {2, -1, 1}};

const double kUp = std::nextafter(2.0, 3.0), kDown = std::nextafter(2.0, 1.0);

struct Row {
  const char* name;
  Near near;
  Aabb box;
  Relation relation;
  Stage stage;
};

const Row kRows[] = {
    {"well_inside", Near::surface, {{4, -1, -1}, {5, 1, 1}}, Relation::inside, Stage::filter},
    {"well_outside", Near::surface, {{4, 9, 9}, {5, 10, 10}}, Relation::outside, Stage::filter},
    {"before_the_wall", Near::surface, {{0.5, -0.1, -0.1}, {1, 0.1, 0.1}}, Relation::outside, Stage::filter},
    {"across_a_side", Near::surface, {{4, 1, -1}, {5, 6, 1}}, Relation::partial, Stage::filter},
    {"corner_on_side_plane_inside", Near::surface, {{4, 0, 0}, {5, 2, 1}}, Relation::inside, Stage::exact},
    {"corner_one_ulp_beyond_side", Near::surface, {{4, 0, 0}, {5, kUp, 1}}, Relation::partial, Stage::exact},
    {"corner_one_ulp_within_side", Near::surface, {{4, 0, 0}, {5, kDown, 1}}, Relation::inside, Stage::exact},
    {"edge_touches_side_from_outside", Near::surface, {{3, 2, 0}, {4, 3, 1}}, Relation::partial, Stage::exact},
    {"edge_one_ulp_outside_side", Near::surface, {{3, kUp, 0}, {4, 3, 1}}, Relation::outside, Stage::exact},
    {"vertex_touches_corner_ray", Near::surface, {{3, 2, 2}, {4, 3, 3}}, Relation::partial, Stage::exact},
    {"face_on_near_plane", Near::surface, {{2, -0.5, -0.5}, {3, 0.5, 0.5}}, Relation::inside, Stage::exact},
    {"face_on_near_plane_from_before", Near::surface, {{1, -0.5, -0.5}, {2, 0.5, 0.5}}, Relation::partial, Stage::exact},
    {"one_ulp_before_near_plane", Near::surface, {{1, -0.5, -0.5}, {kDown, 0.5, 0.5}}, Relation::outside, Stage::exact},
    {"holds_the_eye", Near::surface, {{-1, -1, -1}, {1, 1, 1}}, Relation::outside, Stage::filter},
    {"holds_eye_and_wall", Near::surface, {{-9, -9, -9}, {9, 9, 9}}, Relation::partial, Stage::filter},
    {"flat_box_inside", Near::surface, {{4, -1, -1}, {4, 1, 1}}, Relation::inside, Stage::filter},
    {"flat_box_on_near_plane", Near::surface, {{2, -1, -1}, {2, 1, 1}}, Relation::inside, Stage::exact},
    {"point_inside", Near::surface, {{4, 0, 0}, {4, 0, 0}}, Relation::inside, Stage::filter},
    {"point_on_corner_ray", Near::surface, {{4, 2, 2}, {4, 2, 2}}, Relation::inside, Stage::exact},
    {"point_at_wall_corner", Near::surface, {{2, 1, 1}, {2, 1, 1}}, Relation::inside, Stage::exact},
    {"point_at_the_eye", Near::surface, {{0, 0, 0}, {0, 0, 0}}, Relation::outside, Stage::filter},
    {"needle_past_a_side", Near::surface, {{8, 4.75, -9}, {9, 5, 9}}, Relation::outside, Stage::filter},
    {"needle_touches_a_side", Near::surface, {{8, 4.5, -9}, {9, 5, 9}}, Relation::partial, Stage::exact},
    {"shadow_passes_through_face", Near::surface, {{10, -50, -50}, {11, 50, 50}}, Relation::partial, Stage::filter},
    // All four corners of the wall are equally far: the first counts, and the near plane passes through (2, -1, -1).
    {"farthest_tie_touching", Near::farthest, {{4, -1, -1}, {5, 1, 1}}, Relation::inside, Stage::exact},
    {"farthest_tie_beyond", Near::farthest, {{4.5, -1, -1}, {5, 1, 1}}, Relation::inside, Stage::filter},
    {"farthest_cuts_other_corner", Near::farthest, {{2.5, 0.9, 0.9}, {2.6, 1, 1}}, Relation::outside, Stage::filter},
    {"farthest_corner_itself", Near::farthest, {{2, -1, -1}, {2, -1, -1}}, Relation::inside, Stage::exact},
};

ShadowFrustum frustum(const Viewpoint& viewpoint, const std::vector<Vec3>& loop, Near near) {
  auto result = ShadowFrustum::make(viewpoint, loop, near);
  EXPECT_EQ(result.refusal, Refusal::none) << to_string(result.refusal);
  return *result.frustum;
}

class Degenerate : public testing::TestWithParam<Row> {};

TEST_P(Degenerate, AnswerAndStage) {
  const Row& row = GetParam();
  const Decision decision = overlap_certified(frustum(Viewpoint::eye({0, 0, 0}), kWall, row.near), row.box);
  EXPECT_EQ(to_string(decision.relation), to_string(row.relation));
  EXPECT_EQ(decision.stage, row.stage);
}

/// A copy of the scene on which every operation is exact.
struct Copy {
  const char* name;
  Vec3 (*map)(const Vec3&);
};

const Copy kCopies[] = {
    {"axes permuted",
     [](const Vec3& v) {
       return Vec3{v.y, v.z, v.x};
     }},
    {"axes swapped",
     [](const Vec3& v) {
       return Vec3{v.y, v.x, v.z};
     }},
    {"mirrored",
     [](const Vec3& v) {
       return Vec3{-v.x, v.y, -v.z};
     }},
    {"scaled by 2^-60",
     [](const Vec3& v) {
       return Vec3{v.x * 0x1p-60, v.y * 0x1p-60, v.z * 0x1p-60};
     }},
    {"scaled by 2^60",
     [](const Vec3& v) {
       return Vec3{v.x * 0x1p60, v.y * 0x1p60, v.z * 0x1p60};
     }},
};

Aabb mapped(const Aabb& box, const Copy& copy) {
  const Vec3 a = copy.map(box.min), b = copy.map(box.max);
  Aabb result;
  for (int axis = 0; axis < 3; ++axis) {
    result.min[axis] = std::min(a[axis], b[axis]);
    result.max[axis] = std::max(a[axis], b[axis]);
  }
  return result;
}

TEST_P(Degenerate, CopiesAgree) {
  const Row& row = GetParam();
  for (const Copy& copy : kCopies) {
    std::vector<Vec3> loop;
    for (const Vec3& v : kWall) loop.push_back(copy.map(v));
    const Decision decision = overlap_certified(frustum(Viewpoint::eye({0, 0, 0}), loop, row.near), mapped(row.box, copy));
    EXPECT_EQ(to_string(decision.relation), to_string(row.relation)) << copy.name;
  }
}

TEST_P(Degenerate, LoopMayTurnEitherWayAndCarryNeedlessVertices) {
  const Row& row = GetParam();
  // The tie among farthest vertices goes to the first, so each loop keeps (2, -1, -1) first.
  const std::vector<std::vector<Vec3>> loops{
      {kWall[0], kWall[3], kWall[2], kWall[1]},
      {kWall[0], {2, 0, -1}, kWall[1], {2, 1, 0.25}, kWall[2], kWall[3]},
      {kWall[0], kWall[0], kWall[1], kWall[2], kWall[2], kWall[2], kWall[3]},
  };
  for (const auto& loop : loops) {
    const Decision decision = overlap_certified(frustum(Viewpoint::eye({0, 0, 0}), loop, row.near), row.box);
    EXPECT_EQ(to_string(decision.relation), to_string(row.relation));
  }
}

INSTANTIATE_TEST_SUITE_P(Rows, Degenerate, testing::ValuesIn(kRows),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(Overlap, FarFromTheOriginNothingIsLost) {
  const double o = 4e9;  // ulp 2^-20
  std::vector<Vec3> loop;
  for (const Vec3& v : kWall) loop.push_back({v.x + o, v.y + o, v.z + o});
  const ShadowFrustum shadow = frustum(Viewpoint::eye({o, o, o}), loop, Near::surface);
  const double beyond = std::nextafter(o + 2, o + 3);
  EXPECT_EQ(overlap_certified(shadow, Aabb{{o + 4, o, o}, {o + 5, o + 2, o + 1}}).relation, Relation::inside);
  EXPECT_EQ(overlap_certified(shadow, Aabb{{o + 4, o, o}, {o + 5, beyond, o + 1}}).relation, Relation::partial);
}

TEST(Overlap, SixtyFourSidesAllCount) {
  // A 64-gon inscribed in the circle of radius 1 about the x axis at x = 2; a box between chord and circle is not hidden.
  std::vector<Vec3> loop;
  constexpr double kPi = 3.14159265358979323846;
  for (int i = 0; i < 64; ++i) loop.push_back({2, std::cos(2 * kPi * i / 64), std::sin(2 * kPi * i / 64)});
  const ShadowFrustum shadow = frustum(Viewpoint::eye({0, 0, 0}), loop, Near::surface);
  ASSERT_EQ(shadow.plane_count(), 65U);
  for (int i = 0; i < 64; ++i) {
    const double angle = 2 * kPi * (i + 0.5) / 64;  // the middle of a chord lies at radius cos(pi / 64) = 0.9988
    const auto at = [&](double radius) { return Vec3{4, 2 * radius * std::cos(angle), 2 * radius * std::sin(angle)}; };
    EXPECT_EQ(overlap_certified(shadow, Aabb{at(0.9995), at(0.9995)}).relation, Relation::outside) << i;
    EXPECT_EQ(overlap_certified(shadow, Aabb{at(0.9980), at(0.9980)}).relation, Relation::inside) << i;
  }
}

TEST(Overlap, ShortSilhouetteEdgesCount) {
  // The corner (1, 1) cut off by 1e-9: a point in the cut-off corner's shadow is outside.
  const std::vector<Vec3> loop{{2, -1, -1}, {2, 1, -1}, {2, 1, 1 - 1e-9}, {2, 1 - 1e-9, 1}, {2, -1, 1}};
  const ShadowFrustum shadow = frustum(Viewpoint::eye({0, 0, 0}), loop, Near::surface);
  EXPECT_EQ(overlap_certified(shadow, Aabb{{4, 2, 2}, {4, 2, 2}}).relation, Relation::outside);
  EXPECT_EQ(overlap_certified(shadow, Aabb{{4, 2 - 2e-9, 2 - 2e-9}, {4, 2 - 2e-9, 2 - 2e-9}}).relation, Relation::inside);
}

TEST(Overlap, SeparatedByNoPlaneOfTheFrustum) {
  // The shadow of a diamond is |y| + |z| <= x / 2. At x = 4 the box lies beyond the corner at y = 2, but each of the two
  // planes through that corner has a corner of the box on its inner side: only the edges can tell.
  const std::vector<Vec3> diamond{{2, 1, 0}, {2, 0, 1}, {2, -1, 0}, {2, 0, -1}};
  const ShadowFrustum shadow = frustum(Viewpoint::eye({0, 0, 0}), diamond, Near::surface);
  const Aabb beyond{{4, 2.125, -1}, {4, 3, 1}}, touching{{4, 2, -1}, {4, 3, 1}}, across{{4, 1.5, -1}, {4, 3, 1}};
  EXPECT_EQ(conservative_certified(shadow, beyond).relation, Relation::partial);
  EXPECT_EQ(overlap_certified(shadow, beyond).relation, Relation::outside);
  EXPECT_EQ(overlap_certified(shadow, touching).relation, Relation::partial);
  EXPECT_EQ(overlap_certified(shadow, across).relation, Relation::partial);
}

TEST(Overlap, SilhouetteThatReachesBehindTheEye) {
  // A ceiling above the eye: it surrounds the vertical, and rays to its corners leave in all directions.
  const std::vector<Vec3> loop{{-100, -100, 1}, {100, -100, 1}, {100, 100, 1}, {-100, 100, 1}};
  const ShadowFrustum shadow = frustum(Viewpoint::eye({0, 0, 0}), loop, Near::farthest);
  // The near plane through (-100, -100, 1) is -100 x - 100 y + z = 20001.
  EXPECT_EQ(overlap_certified(shadow, Aabb{{0, 0, 20000}, {0, 0, 20000}}).relation, Relation::outside);
  EXPECT_EQ(overlap_certified(shadow, Aabb{{0, 0, 20001}, {0, 0, 20001}}).relation, Relation::inside);
  EXPECT_EQ(overlap_certified(shadow, Aabb{{0, 0, 0}, {1, 1, 30000}}).relation, Relation::partial);
  EXPECT_EQ(overlap_certified(shadow, Aabb{{-30000, -30000, 400}, {-29999, -29999, 401}}).relation, Relation::inside);
}

TEST(Overlap, OrthographicShadowIsAPrism) {
  const ShadowFrustum shadow = frustum(Viewpoint::direction({1, 0, 0}), kWall, Near::surface);
  EXPECT_EQ(overlap_certified(shadow, Aabb{{1e6, -1, -1}, {2e6, 1, 1}}).relation, Relation::inside);
  EXPECT_EQ(overlap_certified(shadow, Aabb{{3, -1, -1}, {4, std::nextafter(1.0, 2.0), 1}}).relation, Relation::partial);
  EXPECT_EQ(overlap_certified(shadow, Aabb{{3, 1, -1}, {4, 2, 1}}).relation, Relation::partial);
  EXPECT_EQ(overlap_certified(shadow, Aabb{{1, -1, -1}, {kDown, 1, 1}}).relation, Relation::outside);
}

TEST(Overlap, OpenNearBoundaryDrawsWhatIsCoplanar) {
  const ShadowFrustum shadow = frustum(Viewpoint::eye({0, 0, 0}), kWall, Near::surface);
  const Aabb on_the_wall{{2, -0.5, -0.5}, {2, 0.5, 0.5}}, behind{{kUp, -0.5, -0.5}, {3, 0.5, 0.5}};
  EXPECT_EQ(conservative_certified(shadow, on_the_wall, NearBoundary::open).relation, Relation::partial);
  EXPECT_EQ(conservative_certified(shadow, behind, NearBoundary::open).relation, Relation::inside);
}

TEST(Overlap, PlainIsWrongWhereCertifiedIsNot) {
  // Boxes whose corner touches the side of a skew shadow within an ulp: rounding must mislead plain somewhere.
  const std::vector<Vec3> loop{{1.1, -0.3, -0.7}, {1.3, 0.9, -0.6}, {1.2, 0.1, 1.1}};
  const Vec3 eye{0.1, 0.2, 0.3};
  const ShadowFrustum shadow = frustum(Viewpoint::eye(eye), loop, Near::farthest);
  int wrong = 0;
  for (int i = 1; i < 2000; ++i) {
    const double s = 1 + i * 0.001, t = i * 0.0005;  // a point of the side through corners 0 and 1, rounded
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) {
      p[axis] = eye[axis] + 5 * s * ((1 - t) * (loop[0][axis] - eye[axis]) + t * (loop[1][axis] - eye[axis]));
    }
    wrong += overlap_plain(shadow, Aabb{p, p}) != overlap_certified(shadow, Aabb{p, p}).relation;
  }
  std::printf("plain is wrong on %d of 1999 points that touch\n", wrong);
  EXPECT_GT(wrong, 0);
}

}  // namespace
