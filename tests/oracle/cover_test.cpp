// SPDX-License-Identifier: MIT
// The oracle's joined shadows: the near plane, refusals, and exact visibility, which shares nothing with them.
#include "occlude/oracle/cover.h"

#include <gtest/gtest.h>

#include <vector>

#include "occlude/fuzz/random.h"
#include "occlude/oracle/visibility.h"

namespace cover_test {

using namespace occlude;
using namespace occlude::oracle;

const Viewpoint kOrigin{{0, 0, 0}};

Loop wall(double x, double y0, double y1) { return {{x, y0, -1}, {x, y1, -1}, {x, y1, 1}, {x, y0, 1}}; }

TEST(OracleCover, OnlyWhatIsDrawnHides) {
  const Box box = Aabb{{4, -1, -1}, {5, 1, 1}};
  const auto relation = [&](double depth) {
    return relation_to_cover(kOrigin, {wall(2, -1, 1)}, box, HalfSpaceCoefficients{1, 0, 0, -depth}).relation;
  };
  EXPECT_EQ(relation(2), Relation::inside);
  EXPECT_EQ(relation(2.5), Relation::partial);
}

TEST(OracleCover, RefusesWithTheReason) {
  const Box box = Aabb{{4, -1, -1}, {5, 1, 1}};
  EXPECT_NE(relation_to_cover(kOrigin, {{{1, 1, 1}, {2, 2, 2}}}, box).refusal, "");
  EXPECT_NE(relation_to_cover({{0, 0, 0}, true}, {}, box).refusal, "");
  EXPECT_NE(relation_to_cover(kOrigin, {wall(0x1p101, 0, 1)}, box).refusal, "");
  EXPECT_NE(relation_to_cover(kOrigin, {}, Aabb{{5, 0, 0}, {4, 1, 1}}).refusal, "");
}

/// When a box is inside the shadow, none of its faces shows. When a face shows, the box is not inside. When no face shows,
/// the box may still touch what is in front of it, and is then not inside.
TEST(OracleCover, AgreesWithExactVisibility) {
  int hidden = 0, shown = 0, touching = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    fuzz::Random random(seed);
    const auto point = [&] {
      return Point{1.0 * random.integer(1, 3), 1.0 * random.integer(-3, 3), 1.0 * random.integer(-3, 3)};
    };
    std::vector<Loop> polygons;
    for (std::size_t count = 1 + random.index(5); polygons.size() < count;) {
      polygons.push_back({point(), point(), point()});
      if (polygons.size() > 1 && random.chance(0.6)) {
        polygons.back()[0] = polygons[polygons.size() - 2][1];
        polygons.back()[1] = polygons[polygons.size() - 2][2];
      }
    }
    const Point low{1.0 * random.integer(2, 6), 1.0 * random.integer(-1, 1), 1.0 * random.integer(-1, 1)};
    const Aabb box{low, {low[0] + 1, low[1] + 1, low[2] + 1}};
    std::vector<Triangle> scene;
    for (const Loop& p : polygons) scene.push_back({p[0], p[1], p[2]});
    const auto corner = [&](unsigned i) {
      return Point{(i & 1U ? box.max : box.min)[0], (i & 2U ? box.max : box.min)[1], (i & 4U ? box.max : box.min)[2]};
    };
    for (unsigned axis = 0; axis < 3; ++axis) {
      const unsigned u = 1U << (axis + 1) % 3, v = 1U << (axis + 2) % 3;
      for (const unsigned base : {0U, 1U << axis}) {
        scene.push_back({corner(base), corner(base | u), corner(base | u | v)});
        scene.push_back({corner(base), corner(base | u | v), corner(base | v)});
      }
    }
    const std::vector<bool> visible = visible_triangles(kOrigin, scene, {});
    bool shows = false;
    for (std::size_t i = polygons.size(); i < visible.size(); ++i) shows = shows || visible[i];
    const bool is_inside = relation_to_cover(kOrigin, polygons, box).relation == Relation::inside;
    ASSERT_FALSE(is_inside && shows) << seed;
    ++(is_inside ? hidden : shows ? shown : touching);
  }
  EXPECT_GT(hidden, 50);
  EXPECT_GT(shown, 500);
  EXPECT_GT(touching, 5);
}

}  // namespace cover_test
