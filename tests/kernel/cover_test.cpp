// SPDX-License-Identifier: MIT
// Joined shadows: boxes behind several polygons with known answers, and changes that must not change the answers.
#include "occlude/kernel/cover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <variant>
#include <vector>

#include "hand_cases.h"
#include "occlude/fuzz/random.h"
#include "sanitized.h"

namespace cover_test {

using namespace occlude::kernel;
using occlude::unless_sanitized;
using occlude::fuzz::Random;
using Polygons = std::vector<Cover::Polygon>;

const Viewpoint kOrigin = Viewpoint::eye({0, 0, 0});

/// The rectangle in the plane of this x, from (y0, z0) to (y1, z1).
Cover::Polygon wall(double x, double y0, double y1, double z0 = -1, double z1 = 1) {
  return {{x, y0, z0}, {x, y1, z0}, {x, y1, z1}, {x, y0, z1}};
}

Polygons with(Polygons polygons, const Polygons& more) {
  polygons.insert(polygons.end(), more.begin(), more.end());
  return polygons;
}

using enum Relation;

class Covers : public testing::TestWithParam<occlude::HandCover> {};

TEST_P(Covers, AnswerAndStage) {
  const occlude::HandCover& row = GetParam();
  const auto made = Cover::make(row.viewpoint, row.polygons);
  ASSERT_TRUE(made.cover);
  const Decision decision = std::visit([&](const auto& box) { return overlap_certified(*made.cover, box); }, row.box);
  EXPECT_EQ(to_string(decision.relation), to_string(row.relation));
  EXPECT_EQ(decision.stage, row.stage);
}

INSTANTIATE_TEST_SUITE_P(Rows, Covers, testing::ValuesIn(occlude::hand_covers()),
                         [](const auto& row) { return row.param.id; });

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

/// What the near plane cuts off does not hide, and the cut itself leaves no gap.
TEST(Cover, OnlyWhatIsDrawnHides) {
  const Aabb box{{4, -1, -1}, {5, 1, 1}};
  // A roof from before x = 1 to beyond it. The upper part of the box is seen through what is cut off.
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
  for (std::uint64_t seed = 0; seed < unless_sanitized(3000U, 600U); ++seed) {
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
  EXPECT_GT(hidden, unless_sanitized(300, 60));
}

/// Property (3).
TEST(Cover, MorePolygonsHideNoLessAndOfLessBoxMore) {
  for (std::uint64_t seed = 0; seed < unless_sanitized(3000U, 600U); ++seed) {
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

/// Half edges in one plane make a hexagon. Each face of the box is a part of it, so all of them are tested.
TEST(Cover, OfAFlatBoxAllFacesCount) {
  const Obb hexagon{{4, 0, 0}, {{{0, 1, 0}, {0, 0, 1}, {0, 1, 1}}}};
  const auto answer = [&](double y, double z, double reach) {
    // A large half of the plane x = 2: it ends at the share `reach` of the way to (y, z).
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

}  // namespace cover_test
