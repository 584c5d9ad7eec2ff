// SPDX-License-Identifier: MIT
// Boxes in the umbra and penumbra for a region of viewpoints.
#include "occlude/kernel/region_shadow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "cases/ask.h"
#include "hand_cases.h"
#include "kernel/cube.h"
#include "occlude/fuzz/cases.h"
#include "occlude/fuzz/random.h"
#include "sanitized.h"
#include "seed.h"

namespace region_shadow_test {

using namespace occlude::kernel;
using occlude::unless_sanitized;
using occlude::fuzz::Random;

constexpr Relation kInside = Relation::inside, kPartial = Relation::partial, kOutside = Relation::outside;

double above(double x) { return std::nextafter(x, HUGE_VAL); }
double below(double x) { return std::nextafter(x, -HUGE_VAL); }

/// A square of eyes at x = 0, of half side 1, and walls before it.
const ViewRegion kSquare = ViewRegion::eyes({{0, 0, 0}, {{{0, 1, 0}, {0, 0, 1}, {}}}});

std::vector<Vec3> wall(double x, double half) {
  return {{x, -half, -half}, {x, half, -half}, {x, half, half}, {x, -half, half}};
}

RegionShadow shadow(const ViewRegion& region, const std::vector<Vec3>& loop, ShadowKind kind) {
  const auto [made, refusal] = RegionShadow::make(region, loop, kind);
  EXPECT_EQ(refusal, Refusal::none);
  return *made;
}

Aabb box(double x, double y, double width) { return {{x, y, 0}, {x + width, y + width, 0}}; }

/// The wall at x = 2 has half side w. At x = 4 the umbra has half side 2 w - 1, because an eye at 1 sees through w; and the
/// penumbra has 2 w + 1.
struct Row {
  const char* name;
  ShadowKind kind;
  double w;
  Aabb box;
  Relation closed, open;
};

constexpr ShadowKind kUmbra = ShadowKind::umbra, kPenumbra = ShadowKind::penumbra;

const Row kRows[] = {
    {"umbra_up_to_its_border", kUmbra, 2, {{4, -3, -3}, {4, 3, 3}}, kInside, kInside},
    {"an_ulp_beyond", kUmbra, 2, {{4, -3, -3}, {4, above(3), 3}}, kPartial, kPartial},
    {"an_ulp_beyond_alone", kUmbra, 2, {{4, above(3), 0}, {4, 4, 0}}, kOutside, kOutside},
    {"touching_from_beyond", kUmbra, 2, {{4, 3, 0}, {4, 4, 0}}, kPartial, kPartial},
    {"at_the_wall", kUmbra, 2, {{2, -1, -1}, {3, 1, 1}}, kInside, kPartial},
    {"before_the_wall", kUmbra, 2, {{1, -1, -1}, {below(2), 1, 1}}, kOutside, kOutside},
    {"across_the_wall", kUmbra, 2, {{1, -1, -1}, {3, 1, 1}}, kPartial, kPartial},
    {"among_the_eyes", kUmbra, 2, {{-1, -1, -1}, {1, 1, 1}}, kOutside, kOutside},
    // With w = 1 / 2 the umbra ends at (4, 0, 0).
    {"the_end_of_a_small_umbra", kUmbra, 0.5, {{4, 0, 0}, {4, 0, 0}}, kInside, kInside},
    {"beyond_the_end", kUmbra, 0.5, {{above(4), 0, 0}, {5, 1, 1}}, kOutside, kOutside},
    {"a_face_at_the_end", kUmbra, 0.5, {{4, -1, -1}, {5, 1, 1}}, kPartial, kPartial},
    {"around_the_end", kUmbra, 0.5, {{3, -1, -1}, {5, 1, 1}}, kPartial, kPartial},
    {"around_all_of_it", kUmbra, 0.5, {{1, -2, -2}, {5, 2, 2}}, kPartial, kPartial},
    {"beside_the_end_in_no_plane_alone", kUmbra, 0.5, {{4, -1, 0x1p-30}, {5, 1, 1}}, kOutside, kOutside},
    {"below_its_edge", kUmbra, 0.5, {{3, -0.25, -0.25}, {3, 0.25, 0.25}}, kInside, kInside},
    // With w = 1 it is a prism.
    {"a_prism", kUmbra, 1, {{1000, -1, -1}, {1e9, 1, 1}}, kInside, kInside},
    {"beside_a_prism", kUmbra, 1, {{1000, above(1), -1}, {1e9, 2, 1}}, kOutside, kOutside},
    {"penumbra_up_to_its_border", kPenumbra, 2, {{4, -5, -5}, {4, 5, 5}}, kInside, kInside},
    {"an_ulp_beyond_the_penumbra", kPenumbra, 2, {{4, -5, -5}, {4, 5, above(5)}}, kPartial, kPartial},
    {"beside_the_penumbra", kPenumbra, 2, {{4, above(5), -5}, {4, 6, 5}}, kOutside, kOutside},
    {"touching_the_penumbra", kPenumbra, 2, {{4, 5, -5}, {4, 6, 5}}, kPartial, kPartial},
    {"penumbra_at_the_wall", kPenumbra, 2, {{2, -2, -2}, {3, 2, 2}}, kInside, kPartial},
    {"penumbra_before_the_wall", kPenumbra, 2, {{0, -1, -1}, {below(2), 1, 1}}, kOutside, kOutside},
};

class RegionRows : public testing::TestWithParam<Row> {};

Obb oriented(const Aabb& b) {
  const auto half = [&](int k) { return (b.max[k] - b.min[k]) / 2; };
  return {{b.min.x + half(0), b.min.y + half(1), b.min.z + half(2)}, {{{half(0), 0, 0}, {0, half(1), 0}, {0, 0, half(2)}}}};
}

/// Whether oriented() is the same box.
bool is_same(const Aabb& a, const Obb& b) {
  for (int k = 0; k < 3; ++k) {
    const double half = b.half_edges[static_cast<std::size_t>(k)][k];
    if (b.center[k] - half != a.min[k] || b.center[k] + half != a.max[k]) return false;
  }
  return true;
}

/// Whether doubles hold the products of all coordinates.
bool is_exact(double factor, const Aabb& box) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double x : {box.min[axis], box.max[axis]}) {
      if (std::fma(factor, x, -factor * x) != 0) return false;
    }
  }
  return true;
}

TEST_P(RegionRows, Answer) {
  const Row& row = GetParam();
  const RegionShadow of_wall = shadow(kSquare, wall(2, row.w), row.kind);
  EXPECT_EQ(overlap_certified(of_wall, row.box).relation, row.closed);
  EXPECT_EQ(overlap_certified(of_wall, row.box, NearBoundary::open).relation, row.open);
  const Relation planes = conservative_certified(of_wall, row.box).relation;
  EXPECT_TRUE(planes == row.closed || (planes == kPartial && row.closed == kOutside));
  const Obb same = oriented(row.box);
  if (!is_same(row.box, same)) return;
  if (is_exact(1 + 0x1p-40, row.box)) {  // then plain rounds nothing
    EXPECT_EQ(overlap_plain(of_wall, row.box), row.closed);
    EXPECT_EQ(overlap_plain(of_wall, same), row.closed);
  }
  EXPECT_EQ(overlap_certified(of_wall, same).relation, row.closed);
  EXPECT_EQ(overlap_certified(of_wall, same, NearBoundary::open).relation, row.open);
}

/// The same after a linear map, and far beyond what doubles can multiply, with as many digits as fit. So no coordinate is
/// zero, and three planes of a corner of the shadow have nothing in common with the axes.
TEST_P(RegionRows, AnswerAtAnyScaleAfterALinearMap) {
  const Row& row = GetParam();
  const Obb same = oriented(row.box);
  for (const double scale : {1., (1 + 0x1p-40) * 0x1p-90, (1 + 0x1p-40) * 0x1p60}) {
    if (!is_exact(1 + 0x1p-40, row.box) || !is_same(row.box, same)) return;
    const auto mapped = [&](const Vec3& v) {
      return Vec3{scale * (v.x + 2 * v.y - v.z), scale * (3 * v.x + v.y + v.z), scale * (2 * v.y + 3 * v.z - v.x)};
    };
    const auto map_all = [&](auto& points) {
      for (Vec3& v : points) v = mapped(v);
    };
    ViewRegion region = kSquare;
    map_all(region.box.half_edges);
    std::vector<Vec3> loop = wall(2, row.w);
    map_all(loop);
    Obb asked{mapped(same.center), same.half_edges};
    map_all(asked.half_edges);
    EXPECT_EQ(overlap_certified(shadow(region, loop, row.kind), asked).relation, row.closed) << scale;
  }
}

INSTANTIATE_TEST_SUITE_P(Rows, RegionRows, testing::ValuesIn(kRows),
                         [](const auto& row) { return std::string(row.param.name); });

/// The corners of an oriented box are sums of four doubles, here 1 + 2^-60 + 2^-60: an ulp of a double beside 1.
TEST(RegionShadow, CornersOfTheRegionAreNotRounded) {
  const auto relation = [](double more) {
    const ViewRegion region = ViewRegion::eyes({{0, 1, 0}, {{{0, more, 0}, {0, more, 0}, {0, 0, 1}}}});
    return overlap_certified(shadow(region, wall(2, 2), kUmbra), Aabb{{4, 0, 0}, {4, 3, 0}}).relation;
  };
  EXPECT_EQ(overlap_certified(shadow(kSquare, wall(2, 2), kUmbra), Aabb{{4, 0, 0}, {4, 3, 0}}).relation, kInside);
  EXPECT_EQ(relation(0), kInside);
  EXPECT_EQ(relation(0x1p-60), kPartial) << "an eye at 1 + 2^-59 sees (4, 3, 0)";
}

TEST(RegionShadow, DirectionsOfView) {
  // Slopes of -1 to 1: behind the wall at x = 2 the umbra is narrower by as much as it is farther.
  const ViewRegion region = ViewRegion::directions({{1, 0, 0}, {{{0, 1, 0}, {}, {}}}});
  const RegionShadow umbra = shadow(region, wall(2, 2), kUmbra), penumbra = shadow(region, wall(2, 2), kPenumbra);
  EXPECT_EQ(overlap_certified(umbra, box(3, 0, 0)).relation, kInside);
  EXPECT_EQ(overlap_certified(umbra, Aabb{{3, -1, -2}, {3, 1, 2}}).relation, kInside);
  EXPECT_EQ(overlap_certified(umbra, Aabb{{3, -1, -2}, {3, above(1), 2}}).relation, kPartial);
  EXPECT_EQ(overlap_certified(umbra, Aabb{{4, 0, -2}, {4, 0, 2}}).relation, kInside) << "the ridge in which it ends";
  EXPECT_EQ(overlap_certified(umbra, Aabb{{above(4), -1, -2}, {5, 1, 2}}).relation, kOutside);
  EXPECT_EQ(overlap_certified(penumbra, Aabb{{4, -4, -2}, {4, 4, 2}}).relation, kInside);
  EXPECT_EQ(overlap_certified(penumbra, Aabb{{4, above(4), -2}, {4, 5, 2}}).relation, kOutside);
}

/// A cube of side 2 from (3, -1, -1).
TEST(RegionShadow, OfACube) {
  const auto relation = [](const ViewRegion& region, ShadowKind kind, const Aabb& asked) {
    const auto polytope = ConvexPolytope::make(occlude::cube({3, -1, -1})).polytope;
    const auto [made, refusal] = RegionShadow::make(region, *polytope, kind);
    EXPECT_EQ(refusal, Refusal::none);
    return overlap_certified(*made, asked).relation;
  };
  const ViewRegion wide = ViewRegion::eyes({{0, 0, 0}, {{{0, 6, 0}, {}, {}}}});
  EXPECT_EQ(relation(wide, kUmbra, {{3, -1, -1}, {5, 1, 1}}), kInside) << "the cube itself";
  // The eyes at (0, 6) and (0, -6) pass the cube's far corners (5, 1) and (5, -1): the lines cross at (6, 0).
  EXPECT_EQ(relation(wide, kUmbra, {{5, 0, 0}, {6, 0, 0}}), kInside);
  EXPECT_EQ(relation(wide, kUmbra, {{above(6), -1, -1}, {7, 1, 1}}), kOutside);
  EXPECT_EQ(relation(wide, kUmbra, {{5, -1, 1}, {5, 1, 1}}), kInside) << "its far upper edge";
  EXPECT_EQ(relation(wide, kPenumbra, {{6, -4, 0}, {6, 4, 0}}), kInside) << "through (3, 1) from (0, -6) to (6, 8)";
  EXPECT_EQ(relation(wide, kPenumbra, {{6, 8, 0}, {6, 9, 0}}), kPartial);
  EXPECT_EQ(relation(wide, kPenumbra, {{6, above(8), 0}, {6, 9, 0}}), kOutside);
}

class Regions : public testing::TestWithParam<occlude::HandRegion> {};

TEST_P(Regions, AnswerAndStage) {
  const occlude::HandRegion& c = GetParam();
  const auto [made, refusal] = occlude::fuzz::make_shadow(c.question);
  ASSERT_EQ(refusal, Refusal::none);
  const Decision decision = occlude::fuzz::overlap(*made, c.question.box);
  EXPECT_EQ(decision.relation, c.relation);
  EXPECT_EQ(decision.stage, c.stage);
}

INSTANTIATE_TEST_SUITE_P(Rows, Regions, testing::ValuesIn(occlude::hand_regions()),
                         [](const auto& c) { return c.param.id; });

TEST(RegionShadow, AsManyPlanesAsAShadow) {
  const ViewRegion region = ViewRegion::eyes({{0, 0, 0}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}});
  const RegionShadow umbra = shadow(region, wall(2, 1), kUmbra);
  EXPECT_EQ(umbra.plane_count(), 5U);
  EXPECT_EQ(umbra.near_count(), 1U);
}

TEST(RegionShadow, RefusesWithTheReason) {
  const auto of_loop = [](const ViewRegion& region, const std::vector<Vec3>& loop) {
    return RegionShadow::make(region, loop, kUmbra).refusal;
  };
  const auto of_cube = [](const ViewRegion& region) {
    return RegionShadow::make(region, *ConvexPolytope::make(occlude::cube({3, -1, -1})).polytope, kPenumbra).refusal;
  };
  const auto eyes = [](double half) { return ViewRegion::eyes({{0, 0, 0}, {{{half, 0, 0}, {0, 1, 0}, {}}}}); };
  EXPECT_EQ(of_loop(eyes(below(2)), wall(2, 1)), Refusal::none);
  EXPECT_EQ(of_loop(eyes(2), wall(2, 1)), Refusal::eye_in_plane) << "a corner in the plane";
  EXPECT_EQ(of_loop(eyes(3), wall(2, 1)), Refusal::eye_in_plane) << "eyes on both sides";
  EXPECT_EQ(of_loop(kSquare, {{2, 0, 0}, {2, 1, 0}, {2, 2, 0}}), Refusal::eye_in_plane) << "on one line";
  EXPECT_EQ(of_loop(kSquare, {{2, 0, 0}, {2, 1, 0}}), Refusal::too_few_vertices);
  EXPECT_EQ(of_loop(kSquare, {{2, 0, 0}, {2, 2, 0}, {2, 0.5, 0.5}, {2, 0, 2}}), Refusal::not_convex);
  EXPECT_EQ(of_loop(kSquare, {{2, 0, 0}, {2, 1, 0}, {above(2), 1, 1}, {2, 0, 1}}), Refusal::not_coplanar);
  EXPECT_EQ(of_loop(ViewRegion::directions({}), wall(2, 1)), Refusal::zero_direction);
  EXPECT_EQ(of_loop(ViewRegion::directions({{1, 0, 0}, {{{1, 0, 0}, {}, {}}}}), wall(2, 1)), Refusal::eye_in_plane);
  EXPECT_EQ(of_loop(ViewRegion::eyes({{0, 0, 0}, {{{0, NAN, 0}, {}, {}}}}), wall(2, 1)), Refusal::not_finite);
  EXPECT_EQ(of_loop(ViewRegion::eyes({{0, 0, 0x1p101}, {}}), wall(2, 1)), Refusal::out_of_range);
  EXPECT_EQ(of_cube(eyes(below(3))), Refusal::none);
  EXPECT_EQ(of_cube(eyes(3)), Refusal::eye_in_polytope) << "touching a face";
  EXPECT_EQ(of_cube(ViewRegion::eyes({{4, 0, 0}, {{{9, 9, 0}, {}, {}}}})), Refusal::eye_in_polytope)
      << "all corners outside";
  EXPECT_EQ(of_cube(ViewRegion::eyes({{6, 2, 0}, {{{3, -3, 0}, {}, {}}}})), Refusal::none) << "past an edge";
  EXPECT_EQ(of_cube(ViewRegion::eyes({{5, 1, 0}, {{{3, -3, 0}, {}, {}}}})), Refusal::eye_in_polytope) << "at the edge";
  EXPECT_EQ(of_cube(ViewRegion::directions({{1, 1, 0}, {{{2, 2, 0}, {}, {}}}})), Refusal::zero_direction);
  EXPECT_EQ(of_cube(ViewRegion::directions({{1, 1, 0}, {{{2, 1, 0}, {}, {}}}})), Refusal::none) << "past zero";
}

/// Property (6).
TEST(RegionShadow, OfOneViewpointIsTheShadowFrustum) {
  Random random(occlude::seed_of(1));
  std::size_t asked = 0;
  for (int i = 0; i < unless_sanitized(6000, 1500); ++i) {
    const auto families = occlude::fuzz::families();
    occlude::fuzz::Case c = make_case(families[random.index(families.size())], random.bits() >> 16U);
    c.near = Near::surface;
    const auto frustum = make_frustum(c).frustum;
    if (!frustum || frustum->support_plane() || occlude::fuzz::check(c.box) != Refusal::none) continue;
    for (const ShadowKind kind : {kUmbra, kPenumbra}) {
      const auto [made, refusal] =
          occlude::fuzz::make_shadow({{c.viewpoint.kind, {c.viewpoint.value, {}}}, kind, c.occluder, c.box});
      ASSERT_EQ(refusal, Refusal::none);
      ASSERT_EQ(occlude::fuzz::overlap(*made, c.box).relation, occlude::fuzz::overlap(*frustum, c.box).relation);
      ASSERT_EQ(occlude::fuzz::overlap(*made, c.box, NearBoundary::open).relation,
                occlude::fuzz::overlap(*frustum, c.box, NearBoundary::open).relation);
      ++asked;
    }
  }
  EXPECT_GT(asked, unless_sanitized(6000U, 1500U));
}

/// Property (5), for regions whose corners are doubles; and what follows for the outside: a box that meets the umbra meets
/// all shadows, and the penumbra is outside of nothing that is in one of them.
TEST(RegionShadow, IsMadeOfTheShadowsFromTheCorners) {
  Random random(occlude::seed_of(2));
  std::array<int, 3> umbras{}, penumbras{};
  for (int i = 0; i < unless_sanitized(6000, 1500); ++i) {
    const auto whole = [&](int reach) { return 1. * random.integer(-reach, reach); };
    const Vec3 at{4 + whole(1), whole(1) - 3, whole(1) - 3}, u{whole(1), 6 + whole(2), whole(2)},
        v{whole(1), whole(2), 6 + whole(2)};
    const std::vector<Vec3> loop{at, {at.x + u.x, at.y + u.y, at.z + u.z}, {at.x + v.x, at.y + v.y, at.z + v.z}};
    const ViewRegion region = ViewRegion::eyes({{0, 0, 0}, {{{0, whole(1), whole(1)}, {0, whole(1), 0}, {whole(1), 0, 0}}}});
    const auto umbra = RegionShadow::make(region, loop, kUmbra).shadow,
               penumbra = RegionShadow::make(region, loop, kPenumbra).shadow;
    if (!umbra) continue;
    const Vec3 low{6 + whole(2), whole(4) - 2, whole(4) - 2};
    const Aabb asked{low, {low.x + random.integer(0, 2), low.y + random.integer(0, 2), low.z + random.integer(0, 2)}};
    bool is_in_all = true, meets_all = true, is_in_some = false, meets_some = false;
    for (unsigned c = 0; c < 8; ++c) {
      Vec3 eye{};
      for (std::size_t k = 0; k < 3; ++k) {
        const double sign = (c >> k & 1U) != 0 ? 1 : -1;
        for (int axis = 0; axis < 3; ++axis) eye[axis] += sign * region.box.half_edges[k][axis];
      }
      const auto frustum = ShadowFrustum::make(Viewpoint::eye(eye), loop, Near::surface).frustum;
      ASSERT_TRUE(frustum);
      const Relation relation = overlap_certified(*frustum, asked).relation;
      is_in_all = is_in_all && relation == kInside;
      meets_all = meets_all && relation != kOutside;
      is_in_some = is_in_some || relation == kInside;
      meets_some = meets_some || relation != kOutside;
    }
    const Relation of_umbra = overlap_certified(*umbra, asked).relation,
                   of_penumbra = overlap_certified(*penumbra, asked).relation;
    ASSERT_EQ(of_umbra == kInside, is_in_all);
    ASSERT_TRUE(of_umbra == kOutside || meets_all);
    ASSERT_TRUE(!is_in_some || of_penumbra == kInside);
    ASSERT_TRUE(!meets_some || of_penumbra != kOutside);
    ++umbras[static_cast<std::size_t>(of_umbra)];
    ++penumbras[static_cast<std::size_t>(of_penumbra)];
  }
  for (const int count : umbras) EXPECT_GT(count, unless_sanitized(300, 75));
  for (const int count : penumbras) EXPECT_GT(count, unless_sanitized(300, 75));
}

/// Property (5): a smaller region has a larger umbra and a smaller penumbra.
TEST(RegionShadow, GrowsAndShrinksWithTheRegion) {
  Random random(occlude::seed_of(3));
  int differ = 0;
  for (int i = 0; i < unless_sanitized(5000, 1000); ++i) {
    const auto real = [&](double size) { return random.real(-size, size); };
    Obb large{{0, 0, 0}, {}};
    for (Vec3& half_edge : large.half_edges) half_edge = {real(0.5), real(1), real(1)};
    Obb small = large;
    for (Vec3& half_edge : small.half_edges) half_edge = {half_edge.x / 2, half_edge.y / 2, half_edge.z / 2};
    const std::vector<Vec3> loop{
        {3 + real(1), real(2), real(2)}, {3 + real(1), real(2), real(2)}, {3 + real(1), real(2), real(2)}};
    const auto relations = [&](const Obb& eyes, const Aabb& asked) {
      const auto umbra = RegionShadow::make(ViewRegion::eyes(eyes), loop, kUmbra).shadow;
      const auto penumbra = RegionShadow::make(ViewRegion::eyes(eyes), loop, kPenumbra).shadow;
      return umbra ? std::vector{overlap_certified(*umbra, asked).relation, overlap_certified(*penumbra, asked).relation}
                   : std::vector<Relation>{};
    };
    const Vec3 low{5 + real(1), real(3), real(3)};
    const Aabb asked{low, {low.x + 0.2, low.y + 0.2, low.z + 0.2}};
    const auto of_large = relations(large, asked), of_small = relations(small, asked);
    if (of_large.empty()) continue;
    ASSERT_LE(of_small[0], of_large[0]) << "inside, partial, outside is the order of relations";
    ASSERT_GE(of_small[1], of_large[1]);
    ASSERT_LE(of_small[1], of_small[0]) << "the penumbra contains the umbra";
    differ += of_small != of_large ? 1 : 0;
  }
  EXPECT_GT(differ, unless_sanitized(100, 20));
}

}  // namespace region_shadow_test
