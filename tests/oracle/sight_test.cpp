// SPDX-License-Identifier: MIT
// Single lines of sight: a table of what touches, and the joined shadow of the same triangles, which is found in another
// way.
#include "occlude/oracle/sight.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <optional>
#include <vector>

#include "occlude/fuzz/random.h"
#include "occlude/oracle/cover.h"
#include "seed.h"

namespace occlude::oracle {
namespace sight_test {

const Triangle kTriangle{{{2, 0, 0}, {2, 4, 0}, {2, 0, 4}}};

bool is_clear(const Point& eye, const Point& end, const std::vector<Triangle>& triangles = {kTriangle},
              const std::optional<HalfSpaceCoefficients>& drawn = {}) {
  return Sight(triangles, drawn).is_clear(eye, end);
}

TEST(Sight, IsClearUnlessATriangleIsMetBetweenTheEnds) {
  EXPECT_FALSE(is_clear({0, 1, 1}, {4, 1, 1}));
  EXPECT_FALSE(is_clear({4, 1, 1}, {0, 1, 1}));
  EXPECT_TRUE(is_clear({0, 3, 3}, {4, 3, 3}));
  EXPECT_TRUE(is_clear({0, 1, 1}, {1, 1, 1}));
  EXPECT_TRUE(is_clear({3, 1, 1}, {4, 1, 1}));
}

TEST(Sight, MeetsWhatItTouches) {
  EXPECT_FALSE(is_clear({0, 2, 0}, {4, 2, 0}));  // an edge
  EXPECT_FALSE(is_clear({0, 0, 0}, {4, 0, 0}));  // a corner
  EXPECT_FALSE(is_clear({1, 2, 2}, {3, 2, 2}));  // the long edge
  EXPECT_TRUE(is_clear({0, -0x1p-1000, 0}, {4, -0x1p-1000, 0}));
}

TEST(Sight, MeetsNothingAtItsEnds) {
  EXPECT_TRUE(is_clear({0, 1, 1}, {2, 1, 1}));
  EXPECT_TRUE(is_clear({2, 1, 1}, {4, 1, 1}));
  EXPECT_FALSE(is_clear({0, 1, 1}, {2 + 0x1p-50, 1, 1}));
}

TEST(Sight, MeetsWhatHasItInItsPlane) { EXPECT_FALSE(is_clear({2, 9, 0}, {2, 9, 1})); }

TEST(Sight, PassesWhatIsNotDrawn) {
  const auto drawn_from = [](double x) { return HalfSpaceCoefficients{1, 0, 0, -x}; };
  EXPECT_FALSE(is_clear({0, 1, 1}, {4, 1, 1}, {kTriangle}, drawn_from(2)));
  EXPECT_TRUE(is_clear({0, 1, 1}, {4, 1, 1}, {kTriangle}, drawn_from(2 + 0x1p-50)));
  EXPECT_TRUE(is_clear({4, 1, 1}, {0, 1, 1}, {kTriangle}, drawn_from(2 + 0x1p-50)));
}

TEST(Sight, PassesTrianglesWithoutArea) {
  EXPECT_TRUE(is_clear({0, 1, 0}, {4, 1, 0}, {{{{2, 0, 0}, {2, 1, 0}, {2, 2, 0}}}, {{{2, 1, 0}, {2, 1, 0}, {2, 1, 0}}}}));
}

TEST(Sight, OfEachLineDoesNotDependOnTheOneBefore) {
  Sight sight(std::vector<Triangle>{kTriangle, {{{3, 0, 0}, {3, 4, 0}, {3, 0, 4}}}});
  EXPECT_FALSE(sight.is_clear({2.5, 1, 1}, {4, 1, 1}));
  EXPECT_FALSE(sight.is_clear({0, 1, 1}, {2.5, 1, 1}));
  EXPECT_TRUE(sight.is_clear({0, 3, 3}, {4, 3, 3}));
  EXPECT_FALSE(sight.is_clear({2.5, 1, 1}, {4, 1, 1}));
}

/// What is clear is not in the joined shadow, and what is not clear is, unless it touches.
TEST(Sight, AgreesWithTheJoinedShadow) {
  const auto seed = seed_of(3);
  fuzz::Random random(seed);
  const auto point = [&](int low, int high) {
    return Point{random.integer(low, high) / 4.0, random.integer(-12, 12) / 4.0, random.integer(-12, 12) / 4.0};
  };
  std::size_t clear = 0, hidden = 0, others = 0;
  for (int i = 0; i < 4000; ++i) {
    std::vector<Triangle> triangles;
    std::vector<Loop> loops;
    for (int k = random.integer(1, 3); k > 0; --k) {
      const Triangle& t = triangles.emplace_back(Triangle{point(4, 20), point(4, 20), point(4, 20)});
      loops.push_back({t[0], t[1], t[2]});
    }
    std::optional<HalfSpaceCoefficients> drawn;
    if (random.chance(0.5)) drawn = HalfSpaceCoefficients{1, 0, 0, -random.integer(1, 8) / 2.0};
    const Point eye = point(-4, 0), end = point(12, 24);
    const Answer answer = relation_to_cover({eye, false}, loops, Aabb{end, end}, drawn);
    if (!answer.refusal.empty()) continue;
    const bool is_in_shadow = answer.relation == Relation::inside;
    const bool is_clear = Sight(triangles, drawn).is_clear(eye, end);
    ASSERT_FALSE(is_clear && is_in_shadow) << "seed " << seed << ", case " << i;
    (is_clear ? clear : is_in_shadow ? hidden : others) += 1;
  }
  EXPECT_GT(clear, 1000U);
  EXPECT_GT(hidden, 500U);
  EXPECT_LT(others, 200U);
}

}  // namespace sight_test
}  // namespace occlude::oracle
