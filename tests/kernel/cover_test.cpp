// SPDX-License-Identifier: MIT
// Joined shadows: boxes behind several polygons, with known answers, and what must not change them.
#include "occlude/kernel/cover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "occlude/fuzz/random.h"

namespace {

using namespace occlude::kernel;
using occlude::fuzz::Random;
using Polygons = std::vector<Cover::Polygon>;

const Viewpoint kOrigin = Viewpoint::eye({0, 0, 0});
const Viewpoint kAlongX = Viewpoint::direction({1, 0, 0});
constexpr double kGap = 0x1p-60;

/// The rectangle at this x, from (y0, z0) to (y1, z1).
Cover::Polygon wall(double x, double y0, double y1, double z0 = -1, double z1 = 1) {
  return {{x, y0, z0}, {x, y1, z0}, {x, y1, z1}, {x, y0, z1}};
}

/// A ring of four walls about the square |y|, |z| <= 1/2, each T-shaped to the next.
Polygons ring() {
  return {wall(2, -1, 0.5, -1, -0.5), wall(2, 0.5, 1, -1, 0.5), wall(2, -0.5, 1, 0.5, 1), wall(2, -1, -0.5, -0.5, 1)};
}

Polygons with(Polygons polygons, const Polygons& more) {
  polygons.insert(polygons.end(), more.begin(), more.end());
  return polygons;
}

/// Triangles about the origin's x axis that lead round twice, none of them in one plane with the next.
Polygons spiral() {
  Polygons polygons;
  for (int i = 0; i < 16; ++i) {
    const auto corner = [](int k) {
      const double x = 2 + 0.125 * k;
      const double angle = k * 3.14159265358979 / 4;
      return Vec3{x, std::cos(angle) * x, std::sin(angle) * x};
    };
    polygons.push_back({{2, 0, 0}, corner(i), corner(i + 1)});
  }
  return polygons;
}

struct Row {
  const char* name;
  Viewpoint view;
  Polygons polygons;
  Aabb box;
  Relation relation;
  Stage stage;
};

using enum Relation;
using enum Stage;

const Row kRows[] = {
    {"well_behind_one", kOrigin, {{{2, -3, -3}, {2, 3, -3}, {2, 0, 4}}}, {{4, -1, -1}, {5, 1, 1}}, inside, filter},
    {"at_its_diagonal", kOrigin, {wall(2, -1, 1)}, {{4, -1, -1}, {5, 1, 1}}, inside, exact},
    {"well_beside_it", kOrigin, {wall(2, -1, 1)}, {{4, 3, -1}, {5, 5, 1}}, partial, filter},
    {"all_of_the_shadow_at_its_front", kOrigin, {wall(2, -1, 1)}, {{4, -2, -2}, {5, 2, 2}}, inside, exact},
    {"an_ulp_more", kOrigin, {wall(2, -1, 1)}, {{4, -2, -2}, {5, std::nextafter(2, 3), 2}}, partial, exact},
    {"nothing_hides_nothing", kOrigin, {}, {{4, -1, -1}, {5, 1, 1}}, partial, filter},
    {"across_a_common_edge", kOrigin, {wall(2, -1, 0), wall(2, 0, 1)}, {{4, -1, -1}, {5, 1, 1}}, inside, exact},
    {"along_parallel_rays", kAlongX, {wall(2, -1, 0), wall(2, 0, 1)}, {{4, -1, -1}, {5, 1, 1}}, inside, exact},
    {"walls_that_overlap", kOrigin, {wall(2, -1, 0.25), wall(2, 0, 1)}, {{4, -1, -1}, {5, 1, 1}}, inside, exact},
    {"a_gap_of_2^-60", kOrigin, {wall(2, -1, 0), wall(2, kGap, 1)}, {{4, -1, -1}, {5, 1, 1}}, partial, exact},
    {"which_something_else_closes",
     kOrigin,
     {wall(2, -1, 0), wall(2, kGap, 1), wall(3, -0.5, 0.5, -2, 2)},
     {{4, -1, -1}, {5, 1, 1}},
     inside,
     exact},
    {"at_any_depth", kOrigin, {wall(2, -1, 0), wall(3.5, 0, 2, -2, 2)}, {{4, -1, -1}, {5, 1, 1}}, inside, exact},
    {"one_of_them_beyond", kOrigin, {wall(2, -1, 0), wall(6, 0, 3, -3, 3)}, {{4, -1, -1}, {5, 1, 1}}, partial, exact},
    {"a_ring", kOrigin, ring(), {{4, -1, -1}, {5, 1, 1}}, partial, exact},
    {"through_which_it_is_seen", kOrigin, ring(), {{4, -0.5, -0.5}, {5, 0.5, 0.5}}, partial, filter},
    {"a_ring_that_is_stopped",
     kOrigin,
     with(ring(), {wall(3, -0.75, 0.75, -0.75, 0.75)}),
     {{4, -1, -1}, {5, 1, 1}},
     inside,
     exact},
    {"and_stopped_too_late",
     kOrigin,
     with(ring(), {wall(4, -1, 1, -1, 1)}),
     {{4, -0.5, -0.5}, {5, 0.5, 0.5}},
     partial,
     exact},
    {"a_spiral", kOrigin, spiral(), {{9, -1, -1}, {10, 1, 1}}, inside, exact},
    {"a_wall_that_it_touches", kOrigin, {wall(4, -2, 2, -2, 2)}, {{4, -1, -1}, {5, 1, 1}}, partial, exact},
    {"at_a_corner", kOrigin, {{{4, 1, 1}, {2, -3, 1}, {2, 1, -3}, {2, 3, 3}}}, {{4, 0.5, 0.5}, {5, 1, 1}}, partial, exact},
    {"where_an_edge_stands_before_it",
     kOrigin,
     {{{4, 1, 1}, {2, -3, 1}, {2, 1, -3}, {2, 3, 3}}, {{2, 0.5, 0.5}, {2, 0, 0}, {3, 0.75, 0.75}}},
     {{4, 0.5, 0.5}, {5, 1, 1}},
     inside,
     exact},
    {"a_point_behind_a_point", kOrigin, {{{2, 1, 1}, {2, 1, 1}, {2, 1, 1}}}, {{4, 2, 2}, {4, 2, 2}}, inside, exact},
    {"a_line_behind_one", kOrigin, {{{2, -1, 0}, {2, 1, 0}, {2, 0, 0}}}, {{4, -2, 0}, {4, 2, 0}}, inside, exact},
    {"and_behind_two_halves",
     kOrigin,
     {{{2, -1, 0}, {2, 0, 0}, {2, 0, 0}}, {{3, 0, 0}, {3, 2, 0}, {2.5, 1, 0}}},
     {{4, -2, 0}, {4, 2, 0}},
     inside,
     exact},
    {"which_leave_an_ulp",
     kOrigin,
     {{{2, -1, 0}, {2, 0, 0}, {2, 0, 0}}, {{3, kGap, 0}, {3, 2, 0}, {2.5, 1, 0}}},
     {{4, -2, 0}, {4, 2, 0}},
     partial,
     exact},
    {"a_flat_box_edge_on", kOrigin, {wall(2, -1, 1)}, {{4, -2, 0}, {5, 2, 0}}, inside, exact},
    {"behind_the_eye", kOrigin, {wall(2, -1, 1)}, {{-5, -1, -1}, {-4, 1, 1}}, partial, filter},
    {"about_the_eye", kOrigin, {wall(2, -1, 1)}, {{-5, -5, -5}, {4, 1, 1}}, partial, filter},
    {"the_eye_on_its_border", kOrigin, {wall(2, -1, 1)}, {{0, -0.5, -0.5}, {4, 0.5, 0.5}}, partial, exact},
    {"the_eye_at_a_flat_one", kOrigin, {wall(2, -1, 1)}, {{-1, -0.5, 0}, {4, 0.5, 0}}, partial, exact},
    {"a_wall_through_the_eye_hides_its_plane",
     kOrigin,
     {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}},
     {{4, -2, 0}, {5, 2, 0}},
     inside,
     exact},
    {"and_nothing_beside_it",
     kOrigin,
     {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}},
     {{4, -2, 0}, {5, 2, 0x1p-60}},
     partial,
     exact},
    {"a_triangle_that_passes_the_eye",
     kOrigin,
     {{{-8, -9, 1}, {9, -9, 1}, {9, 9, 1}}, {{-8, -9, 1}, {9, 9, 1}, {-8, 9, 1}}},
     {{-3, -3, 4}, {3, 3, 5}},
     inside,
     exact},
    {"a_box_far_larger", kOrigin, {wall(2, -1, 1)}, {{0x1p90, -0x1p99, -1}, {0x1p99, 0x1p99, 1}}, partial, exact},
    {"all_in_a_tiny_part",
     kOrigin,
     {wall(0x1p-90, -0x1p-90, 0), wall(0x1p-90, 0, 0x1p-90, -0x1p-90, 0x1p-90), wall(0x1p-80, -1, 0)},
     {{0x1p90, -0x1p88, -0x1p88}, {0x1p91, 0x1p88, 0x1p88}},
     inside,
     exact},
};

class Covers : public testing::TestWithParam<Row> {};

TEST_P(Covers, AnswerAndStage) {
  const Row& row = GetParam();
  const auto made = Cover::make(row.view, row.polygons);
  ASSERT_TRUE(made.cover);
  const Decision decision = overlap_certified(*made.cover, row.box);
  EXPECT_EQ(decision.relation, row.relation);
  EXPECT_EQ(decision.stage, row.stage);
}

INSTANTIATE_TEST_SUITE_P(Rows, Covers, testing::ValuesIn(kRows), [](const auto& row) {
  std::string name = row.param.name;
  std::ranges::replace_if(
      name, [](char c) { return c == '^' || c == '-'; }, '_');
  return name;
});

TEST(Cover, RefusesWithTheReason) {
  const auto refusal = [](const Viewpoint& view, const Polygons& polygons, std::optional<HalfSpace> drawn = {}) {
    return Cover::make(view, polygons, drawn).refusal;
  };
  EXPECT_EQ(refusal(kOrigin, {wall(2, -1, 1)}), Refusal::none);
  EXPECT_EQ(refusal(Viewpoint::direction({0, 0, 0}), {}), Refusal::zero_direction);
  EXPECT_EQ(refusal(kOrigin, {{{1, 2, 3}, {4, 5, 6}}}), Refusal::too_few_vertices);
  EXPECT_EQ(refusal(kOrigin, {wall(std::nan(""), -1, 1)}), Refusal::not_finite);
  EXPECT_EQ(refusal(kOrigin, {wall(0x1p101, -1, 1)}), Refusal::out_of_range);
  EXPECT_EQ(refusal(kOrigin, {}, HalfSpace{{1, 0, 0}, 0x1p-101}), Refusal::out_of_range);
  EXPECT_EQ(refusal(kOrigin, {}, HalfSpace{{0, 0, 0}, 1}), Refusal::zero_direction);
}

/// What is cut off by the near plane does not hide, and the cut itself leaves no gap.
TEST(Cover, OnlyWhatIsDrawnHides) {
  const Aabb box{{4, -1, -1}, {5, 1, 1}};
  // A roof that leads from before x = 1 to beyond it: seen through what is cut off, the upper part of the box.
  const Polygons roof{{{0.5, -2, 0.5}, {3, -2, -2}, {3, 2, -2}, {0.5, 2, 0.5}}, wall(3, -2, 2, -2, 0)};
  const auto relation = [&](std::optional<HalfSpace> drawn, const Polygons& polygons) {
    return overlap_certified(*Cover::make(kOrigin, polygons, drawn).cover, box).relation;
  };
  EXPECT_EQ(relation({}, roof), inside);
  EXPECT_EQ(relation(HalfSpace{{1, 0, 0}, -0.5}, roof), inside) << "drawn to the very plane";
  EXPECT_EQ(relation(HalfSpace{{1, 0, 0}, -1.5}, roof), partial);
  EXPECT_EQ(relation(HalfSpace{{1, 0, 0}, -2}, {wall(2, -1, 1)}), inside);
  EXPECT_EQ(relation(HalfSpace{{1, 0, 0}, -std::nextafter(2, 3)}, {wall(2, -1, 1)}), partial);
}

Vec3 lattice_point(Random& random, int low_x) {
  return {1.0 * random.integer(low_x, 3), 1.0 * random.integer(-3, 3), 1.0 * random.integer(-3, 3)};
}

Polygons lattice_polygons(Random& random) {
  Polygons polygons;
  for (std::size_t count = 1 + random.index(5); polygons.size() < count;) {
    Cover::Polygon polygon;
    for (int i = 0; i < 4; ++i) polygon.push_back(lattice_point(random, random.chance(0.2) ? -1 : 1));
    if (!polygons.empty() && random.chance(0.5)) polygon[0] = polygons.back()[3];
    polygons.push_back(polygon);
  }
  return polygons;
}

Aabb lattice_box(Random& random) {
  const Vec3 low{1.0 * random.integer(2, 6), 1.0 * random.integer(-1, 1), 1.0 * random.integer(-1, 1)};
  return {low, {low.x + random.integer(0, 2), low.y + random.integer(0, 1), low.z + random.integer(0, 1)}};
}

Relation relation(const Viewpoint& view, const Polygons& polygons, const Aabb& box) {
  return overlap_certified(*Cover::make(view, polygons).cover, box).relation;
}

/// Property (2).
TEST(Cover, DependsOnTheSetsAlone) {
  std::mt19937 shuffle(1);
  int hidden = 0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    Random random(seed);
    const Polygons polygons = lattice_polygons(random);
    const Aabb box = lattice_box(random);
    const Relation answer = relation(kOrigin, polygons, box);
    hidden += answer == inside ? 1 : 0;

    Polygons other = with(polygons, {polygons[0]});
    std::ranges::shuffle(other, shuffle);
    for (Cover::Polygon& polygon : other) polygon.insert(polygon.begin() + 1, polygon[1]);
    ASSERT_EQ(relation(kOrigin, other, box), answer) << "in another order, one of them twice, seed " << seed;

    const auto image = [](const auto& map, const Polygons& of, const Aabb& b) {
      Polygons mapped = of;
      for (Cover::Polygon& polygon : mapped) {
        for (Vec3& v : polygon) v = map(v);
      }
      const Vec3 p = map(b.min), q = map(b.max);
      Aabb to;
      for (int axis = 0; axis < 3; ++axis) {
        to.min[axis] = std::min(p[axis], q[axis]);
        to.max[axis] = std::max(p[axis], q[axis]);
      }
      return relation(Viewpoint::eye(map({0, 0, 0})), mapped, to);
    };
    ASSERT_EQ(image([](const Vec3& v) { return Vec3{v.z, v.x, v.y}; }, polygons, box), answer) << "axes, seed " << seed;
    ASSERT_EQ(image([](const Vec3& v) { return Vec3{v.x, -v.z, v.y}; }, polygons, box), answer) << "turn, seed " << seed;
    ASSERT_EQ(image([](const Vec3& v) { return Vec3{-v.x, v.y, v.z}; }, polygons, box), answer) << "mirror, seed " << seed;
    ASSERT_EQ(image(
                  [](const Vec3& v) {
                    return Vec3{0x1p-90 * v.x, 0x1p-90 * v.y, 0x1p-90 * v.z};
                  },
                  polygons, box),
              answer)
        << "scaled, seed " << seed;
    ASSERT_EQ(image(
                  [](const Vec3& v) {
                    return Vec3{v.x + 0x1p40, v.y - 3, v.z + 0x1p49};
                  },
                  polygons, box),
              answer)
        << "moved, seed " << seed;
  }
  EXPECT_GT(hidden, 300);
}

/// Property (3).
TEST(Cover, MorePolygonsHideNoLessAndOfLessBoxMore) {
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    Random random(seed);
    const Polygons some = lattice_polygons(random), more = with(some, lattice_polygons(random));
    const Aabb box = lattice_box(random);
    if (relation(kOrigin, some, box) == inside) {
      ASSERT_EQ(relation(kOrigin, more, box), inside) << seed;
    }
    if (relation(kOrigin, more, box) == inside) {
      const Aabb part{{0.5 * (box.min.x + box.max.x), box.min.y, box.min.z}, {box.max.x, box.max.y, box.min.z}};
      ASSERT_EQ(relation(kOrigin, more, part), inside) << seed;
    }
  }
}

/// Half edges in one plane make a hexagon, of which each face of the box is a part: all of them are asked.
TEST(Cover, OfAFlatBoxAllFacesCount) {
  const Obb hexagon{{4, 0, 0}, {{{0, 1, 0}, {0, 0, 1}, {0, 1, 1}}}};
  const auto answer = [&](double y, double z, double reach) {
    // All of the plane x = 2 but what is farther than `reach` of the way to (y, z).
    const double qy = reach * y, qz = reach * z;
    const Cover::Polygon half_plane{{2, qy - 9 * z, qz + 9 * y},
                                    {2, qy + 9 * z, qz - 9 * y},
                                    {2, qy + 9 * z - 19 * y, qz - 9 * y - 19 * z},
                                    {2, qy - 9 * z - 19 * y, qz + 9 * y - 19 * z}};
    return overlap_certified(*Cover::make(kOrigin, Polygons{half_plane}).cover, hexagon).relation;
  };
  for (const auto& [y, z] : {std::pair{2.0, 2.0}, {-2, -2}, {2, 0}, {0, 2}, {-2, 0}, {0, -2}}) {  // its corners
    EXPECT_EQ(answer(y, z, 0.45), partial) << y << " " << z;
    EXPECT_EQ(answer(y, z, 0.55), inside) << y << " " << z;
  }
}

/// The same box, given by a centre and half edges.
TEST(Cover, OrientedBoxesAreThePointsThatTheyMean) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    Random random(seed);
    const Polygons polygons = lattice_polygons(random);
    const Aabb box = lattice_box(random);
    Obb same;
    for (int axis = 0; axis < 3; ++axis) {
      same.center[axis] = 0.5 * (box.min[axis] + box.max[axis]);
      same.half_edges[static_cast<std::size_t>((axis + 1) % 3)][axis] = 0.5 * (box.max[axis] - box.min[axis]);
    }
    const Viewpoint view = random.chance(0.5) ? kOrigin : Viewpoint::direction({2, 1, -1});
    const Cover cover = *Cover::make(view, polygons).cover;
    ASSERT_EQ(overlap_certified(cover, same).relation, overlap_certified(cover, box).relation) << seed;
  }
}

}  // namespace
