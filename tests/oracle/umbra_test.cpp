// SPDX-License-Identifier: MIT
// Boxes in the shadow of one occluder from every eye of a region.
#include <gtest/gtest.h>

#include <array>

#include "occlude/fuzz/random.h"
#include "occlude/oracle/region.h"
#include "oracle/region_scenes.h"
#include "oracle/vocabulary.h"

namespace occlude::oracle {
namespace umbra_test {

Obb square(double half) { return {{0, 0, 0}, {{{0, half, 0}, {0, 0, half}, {0, 0, 0}}}}; }

Loop wall(double x, double half) { return {{x, -half, -half}, {x, half, -half}, {x, half, half}, {x, -half, half}}; }

Relation relation(const EyeRegion& eyes, const Occluder& occluder, const Box& box) {
  const Answer answer = relation_to_umbra(eyes, occluder, box);
  EXPECT_EQ(answer.refusal, "");
  return answer.relation;
}

/// An eye at 1 sees y = -1 at x = 4 through y = 0 at x = 2, and -1 sees -3 through -2.
TEST(Umbra, OfAWall) {
  const auto of = [](double half, double from) {
    return relation(square(1), wall(2, half), Aabb{{from, -3, -3}, {4, 3, 3}});
  };
  EXPECT_EQ(of(2, 4), kInside) << "(3 + 1) / 2";
  EXPECT_EQ(of(below(2), 4), kPartial);
  EXPECT_EQ(of(3, above(2)), kInside);
  EXPECT_EQ(of(3, 2), kPartial) << "it touches the wall";
  EXPECT_EQ(relation(square(1), wall(-2, 9), Aabb{{4, 0, 0}, {5, 1, 1}}), kPartial) << "behind the eyes";
  EXPECT_EQ(relation(Obb{{0, 0, 0}, {{{2, 0, 0}, {}, {}}}}, wall(2, 9), Aabb{{4, 0, 0}, {5, 1, 1}}), kPartial)
      << "an eye touches the wall";
  EXPECT_EQ(relation(Obb{{0, 0, 0}, {{{below(2), 0, 0}, {}, {}}}}, wall(2, 9), Aabb{{4, 0, 0}, {5, 1, 1}}), kInside);
}

/// 3 x + 4 y = 5 touches the unit ball at (3/5, 4/5) and goes through (3, -1) and (7, -4).
TEST(Umbra, OfABallAndItsTangent) {
  const auto of = [](double end) {
    const Loop polygon{{3, end, -9}, {3, end, 9}, {3, -9, 9}, {3, -9, -9}};
    return relation(Ball{{0, 0, 0}, 1}, polygon, Aabb{{7, -4, 0}, {7, -4, 0}});
  };
  EXPECT_EQ(of(-1), kInside);
  EXPECT_EQ(of(below(-1)), kPartial);
  EXPECT_EQ(relation(Ball{{0, 0, 0}, below(3)}, wall(3, 1000), Aabb{{7, -4, 0}, {7, -4, 0}}), kInside);
  EXPECT_EQ(relation(Ball{{0, 0, 0}, 3}, wall(3, 1000), Aabb{{7, -4, 0}, {7, -4, 0}}), kPartial);
}

TEST(Umbra, RefusesWithTheReason) {
  const Box box = Aabb{{4, 0, 0}, {5, 1, 1}};
  EXPECT_NE(relation_to_umbra(Ball{{0, 0, 0}, -1}, wall(2, 1), box).refusal, "");
  EXPECT_NE(relation_to_umbra(Ball{{kNan, 0, 0}, 1}, wall(2, 1), box).refusal, "");
  EXPECT_NE(relation_to_umbra(Ball{}, Loop{{2, 0, 0}, {2, 1, 0}}, box).refusal, "");
  EXPECT_NE(relation_to_umbra(Ball{}, Loop{{2, 0, 0}, {2, 1, 0}, {3, 1, 1}, {2, 0, 1}}, box).refusal, "") << "not coplanar";
  EXPECT_NE(relation_to_umbra(Ball{}, wall(2, 1), Aabb{{5, 0, 0}, {4, 1, 1}}).refusal, "");
}

/// A box of eyes is hidden when its corners are, and so is a ball when points of it are that are tried, if it is hidden.
TEST(Umbra, IsTheShadowFromEveryCorner) {
  int inside = 0, partial = 0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    fuzz::Random random(seed);
    const auto at = [&](double x, int size) {
      return Point{x + random.integer(-1, 1), 1. * random.integer(-size, size), 1. * random.integer(-size, size)};
    };
    const Point p = at(4, 4), u = at(0, 5), v = at(0, 5), w = at(0, 5);
    Occluder occluder = Loop{p, plus(p, 1, u), plus(plus(p, 1, u), 1, v), plus(p, 1, v)};
    if (random.chance(0.5)) {
      occluder = Polytope{{p, plus(p, 1, u), plus(p, 1, v), plus(p, 1, w)}, {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};
    }
    const Obb eyes{at(0, 0), {{{0.5, 0, 0}, {0, 1. * random.integer(0, 1), 0}, {0, 0, 0.5 * random.integer(0, 1)}}}};
    const Point low = at(7, 2);
    const Aabb box{low, plus(low, 1, {1, 1. * random.integer(0, 1), 1})};
    const Answer answer = relation_to_umbra(eyes, occluder, box);
    if (!answer.refusal.empty()) continue;
    bool is_inside = true;
    for (const double x : {-1, 1}) {
      for (const double y : {-1, 1}) {
        for (const double z : {-1, 1}) {
          Point e = eyes.center;
          for (std::size_t k = 0; k < 3; ++k) e[k] += std::array{x, y, z}[k] * eyes.half_edges[k][k];
          is_inside = is_inside && Shadow({e}, occluder, kSurface).refute_cull(box).empty();
        }
      }
    }
    EXPECT_EQ(answer.relation, is_inside ? kInside : kPartial) << seed;
    ++(is_inside ? inside : partial);
    RegionScenes scenes(seed);
    const EyeRegion ball = Ball{eyes.center, 0.5};
    if (relation(ball, occluder, box) == kPartial) continue;
    for (int i = 0; i < 20; ++i) EXPECT_EQ(Shadow({scenes.eye(ball)}, occluder, kSurface).refute_cull(box), "") << seed;
  }
  EXPECT_GT(inside, 100);
  EXPECT_GT(partial, 1000);
}

}  // namespace umbra_test
}  // namespace occlude::oracle
