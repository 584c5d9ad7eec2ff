// SPDX-License-Identifier: MIT
// Boxes against the union of two shadows.
#include "occlude/kernel/shadow_union.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace shadow_union_test {

using namespace occlude::kernel;

ShadowFrustum shadow(const std::vector<Vec3>& loop, Near near = Near::surface) {
  return *ShadowFrustum::make(Viewpoint::eye({0, 0, 0}), loop, near).frustum;
}

/// A wall at x = 2 from y = low to y = high, and z from -1 to 1. Seen from the origin, its shadow at depth x is the wall
/// scaled by x / 2.
std::vector<Vec3> wall(double low, double high) { return {{2, low, -1}, {2, high, -1}, {2, high, 1}, {2, low, 1}}; }

struct Row {
  const char* name;
  double low, high;  ///< the extent of the second wall; the first is from -1 to 0
  Aabb box;
  Relation relation;
};

constexpr double kGap = 0x1p-60;

const Row kRows[] = {
    {"in_the_first_alone", 0, 1, {{4, -2, -1}, {5, -1, 1}}, Relation::inside},
    {"across_the_common_edge", 0, 1, {{4, -1, -1}, {5, 1, 1}}, Relation::inside},
    {"all_of_both_at_its_front", 0, 1, {{4, -2, -2}, {5, 2, 2}}, Relation::inside},
    {"one_ulp_beyond_both", 0, 1, {{4, -2, -2}, {5, std::nextafter(2.0, 3), 2}}, Relation::partial},
    {"face_on_the_near_plane", 0, 1, {{2, -1, -1}, {3, 1, 1}}, Relation::inside},
    {"before_the_near_plane", 0, 1, {{std::nextafter(2.0, 1), -1, -1}, {3, 1, 1}}, Relation::partial},
    {"a_gap_of_2^-60", kGap, 1, {{4, -1, -1}, {5, 1, 1}}, Relation::partial},
    {"walls_that_overlap", -0.5, 1, {{4, -2, -2}, {5, 2, 2}}, Relation::inside},
    {"in_neither_touching_both", 0, 1, {{4, -1, 2}, {4, 1, 3}}, Relation::partial},
    {"in_neither", 0, 1, {{4, -1, 3}, {5, 1, 4}}, Relation::outside},
    {"flat_across", 0, 1, {{4, -2, 0}, {4, 2, 0}}, Relation::inside},
};

class UnionRows : public testing::TestWithParam<Row> {};

TEST_P(UnionRows, Answer) {
  const Row& row = GetParam();
  const ShadowFrustum first = shadow(wall(-1, 0)), second = shadow(wall(row.low, row.high));
  EXPECT_EQ(overlap_certified(ShadowUnion{first, second}, row.box).relation, row.relation);
  EXPECT_EQ(overlap_certified(ShadowUnion{second, first}, row.box).relation, row.relation);
}

INSTANTIATE_TEST_SUITE_P(Rows, UnionRows, testing::ValuesIn(kRows), [](const auto& row) {
  std::string name = row.param.name;
  std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)) && c != '_'; });
  return name;
});

TEST(ShadowUnion, OrientedBoxAcrossTheCommonEdge) {
  const ShadowFrustum left = shadow(wall(-1, 0)), right = shadow(wall(0, 1));
  const ShadowUnion both{left, right};
  const Obb diamond{{6, 0, 0}, {Vec3{0, 1.5, 1.5}, Vec3{0, -1.5, 1.5}, Vec3{1, 0, 0}}};  // reaches 3 at x = 5: too far
  EXPECT_EQ(overlap_certified(both, diamond).relation, Relation::partial);
  const Obb touching{{6, 0, 0}, {Vec3{0, 1.25, 1.25}, Vec3{0, -1.25, 1.25}, Vec3{1, 0, 0}}};  // 2.5 at x = 5
  EXPECT_EQ(overlap_certified(both, touching).relation, Relation::inside);
  EXPECT_EQ(overlap_certified(both.first, touching).relation, Relation::partial);
}

TEST(ShadowUnion, OpenNearBoundaryDrawsWhatIsCoplanar) {
  const ShadowFrustum left = shadow(wall(-1, 0)), right = shadow(wall(0, 1));
  const ShadowUnion both{left, right};
  EXPECT_EQ(overlap_certified(both, Aabb{{2, -0.5, 0}, {3, 0.5, 0}}, NearBoundary::open).relation, Relation::partial);
  EXPECT_EQ(overlap_certified(both, Aabb{{std::nextafter(2.0, 3), -0.5, 0}, {3, 0.5, 0}}, NearBoundary::open).relation,
            Relation::inside);
}

/// A wall and a cube share an edge, and the cube shows two faces to the eye. That makes three near planes, and the box
/// reaches the last one at one corner.
TEST(ShadowUnion, EachShadowHasItsOwnNearPlanes) {
  const Viewpoint eye = Viewpoint::eye({0.5, -5, 0.5});
  const std::vector<Vec3> loop{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}};
  Polytope solid{{}, {{0, 2, 6, 4}, {0, 1, 5, 4}, {1, 3, 7, 5}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}}};  // x = 1 first
  for (unsigned i = 0; i < 8; ++i) solid.vertices.push_back({i & 1U ? 2.0 : 1.0, i & 2U ? 1.0 : 0.0, i & 4U ? 1.0 : 0.0});
  const ShadowFrustum wall = *ShadowFrustum::make(eye, loop, Near::surface).frustum;
  const ShadowFrustum cube = *ShadowFrustum::make(eye, *ConvexPolytope::make(solid).polytope, Near::surface).frustum;
  ASSERT_EQ(cube.near_count(), 2U);
  const auto box = [](double y) {
    return Obb{{1.25, y, 0.5}, {Vec3{0.25, -0.5, 0}, Vec3{-0.25, 0.125, 0}, Vec3{0, 0, 0.125}}};
  };
  for (const ShadowUnion& both : {ShadowUnion{wall, cube}, ShadowUnion{cube, wall}}) {
    EXPECT_EQ(overlap_certified(both, box(0.625), NearBoundary::closed).relation, Relation::inside);
    EXPECT_EQ(overlap_certified(both, box(0.625), NearBoundary::open).relation, Relation::partial);
    EXPECT_EQ(overlap_certified(both, box(std::nextafter(0.625, 1)), NearBoundary::open).relation, Relation::inside);
    EXPECT_EQ(overlap_certified(both, box(std::nextafter(0.625, 0)), NearBoundary::closed).relation, Relation::partial);
  }
}

/// Every point of a grid in the box is in one of the shadows when the answer is inside, and in none when it is outside. When
/// it is partial, nearly always some point is in none.
TEST(ShadowUnion, AgreesWithPoints) {
  constexpr std::uint32_t kSeed = 4;
  std::mt19937_64 random(kSeed);
  const auto whole = [&](int low, int high) {
    return static_cast<double>(low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1)));
  };
  int counts[3] = {}, unproved = 0;
  for (int i = 0; i < 4000; ++i) {
    const double a = whole(-2, 0), b = whole(-1, 1);
    const ShadowFrustum first =
        shadow({{2, a - 2, -1}, {2, b, -2}, {2, b, 2}, {2, a - 2, 1}}, i % 2 ? Near::surface : Near::farthest);
    const ShadowFrustum second = shadow({{2, a, -2}, {2, b + 2, -1}, {2, b + 2, 1}, {2, a, 2}});
    const ShadowUnion both{first, second};
    const Vec3 min{whole(1, 5), whole(-8, 4), whole(-6, 3)};
    const Aabb box{min, {min.x + whole(0, 3), min.y + whole(0, 6), min.z + whole(0, 6)}};
    const Relation relation = overlap_certified(both, box).relation;
    ++counts[static_cast<int>(relation)];
    bool some_in = false, some_out = false;
    for (int p = 0; p < 9 * 9 * 9; ++p) {
      const auto at = [&](double low, double high, int step) { return low + (high - low) * step / 8; };
      const Vec3 x{at(box.min.x, box.max.x, p % 9), at(box.min.y, box.max.y, p / 9 % 9), at(box.min.z, box.max.z, p / 81)};
      const auto is_in = [&](const ShadowFrustum& f) {
        return overlap_certified(f, Aabb{x, x}).relation == Relation::inside;
      };
      (is_in(both.first) || is_in(both.second) ? some_in : some_out) = true;
    }
    ASSERT_FALSE(relation == Relation::inside && some_out) << "seed " << kSeed << " case " << i;
    ASSERT_FALSE(relation == Relation::outside && some_in) << "seed " << kSeed << " case " << i;
    unproved += relation == Relation::partial && !some_out;
  }
  std::printf("inside %d partial %d outside %d; partial without a point outside: %d\n", counts[0], counts[1], counts[2],
              unproved);
  EXPECT_GT(counts[0], 100);
  EXPECT_LT(unproved, counts[1] / 20);
}

}  // namespace shadow_union_test
