// SPDX-License-Identifier: MIT
// The other questions, on cases worked out by hand.
#include "occlude/oracle/questions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "oracle/cuboid.h"
#include "oracle/vocabulary.h"

namespace occlude::oracle {
namespace questions_test {

constexpr Viewpoint kUp{{0, 0, 1}, true};

// ------------------------------------------------------------------------------------------------------------ half-spaces

// |x| <= z, |y| <= z, 1 <= z <= 4.
const std::vector<HalfSpaceCoefficients> kPyramid{{-1, 0, 1, 0}, {1, 0, 1, 0},  {0, -1, 1, 0},
                                                  {0, 1, 1, 0},  {0, 0, 1, -1}, {0, 0, -1, 4}};

TEST(HalfSpaces, AgreeWithCasesWorkedOutByHand) {
  const std::pair<Aabb, Relation> cases[] = {
      {{{-1, -1, 3}, {1, 1, 4}}, kInside},        {{{-1, -1, 3}, {1, 1, above(4)}}, kPartial},
      {{{-1, -1, 4}, {1, 1, 5}}, kPartial},       {{{-1, -1, above(4)}, {1, 1, 5}}, kOutside},
      {{{4, 4, 4}, {5, 5, 5}}, kPartial},         {{{-9, -9, -9}, {9, 9, 9}}, kPartial},
      {{{3, -1, 2}, {4, 1, below(3)}}, kOutside}, {{{3, 3, 2}, {4, 4, 3}}, kPartial},
      {{{3, above(3), 2}, {4, 4, 3}}, kOutside},
  };
  for (const auto& [box, expected] : cases) {
    EXPECT_EQ(relation_to_half_spaces(kPyramid, box).relation, expected) << box.min[0] << " " << box.min[2];
  }
}

TEST(HalfSpaces, OneNoneEmptyAndFaulty) {
  const auto ask = [](const std::vector<HalfSpaceCoefficients>& half_spaces, const Box& box) {
    return relation_to_half_spaces(half_spaces, box);
  };
  const Aabb cube{{-1, -1, -1}, {1, 1, 1}};
  EXPECT_EQ(ask({{1, 1, 1, 3}}, cube).relation, kInside);
  EXPECT_EQ(ask({{1, 1, 1, below(3)}}, cube).relation, kPartial);
  EXPECT_EQ(ask({{1, 1, 1, -3}}, cube).relation, kPartial);
  EXPECT_EQ(ask({{1, 1, 1, below(-3)}}, cube).relation, kOutside);
  EXPECT_EQ(ask({{1, 1, 1, -3}}, Obb{{2, 0, 0}, {{{1, 0, 0}, {0, 0, 0}, {0, 0, 0}}}}).relation, kPartial);
  EXPECT_EQ(ask({}, cube).relation, kInside);
  EXPECT_EQ(ask({{0, 0, 0, 0}}, cube).relation, kInside);
  EXPECT_EQ(ask({{0, 0, 0, -1}}, cube).relation, kOutside);
  EXPECT_EQ(ask({{1, 0, 0, 0}, {-1, 0, 0, 0}}, cube).relation, kPartial);
  EXPECT_EQ(ask({{1, 0, 0, 0}, {-1, 0, 0, -0x1p-60}}, cube).relation, kOutside);
  EXPECT_EQ(ask({{1, 0, 0, kNan}}, cube).refusal, "a number is not finite");
  EXPECT_EQ(ask({{1, 0, 0, 0}}, Aabb{{1, 0, 0}, {0, 0, 0}}).refusal, "the box has min > max");
}

// -------------------------------------------------------------------------------------------------------------- silhouette

std::vector<Point> sorted(std::vector<Point> points) {
  std::ranges::sort(points);
  return points;
}

TEST(Outline, OfAPolygonLeavesOutWhatDoesNotTurn) {
  EXPECT_EQ(outline(kOrigin, kSquare).corners, sorted(kSquare));
  Loop loop = kSquare;
  loop.insert(loop.begin() + 1, {0, -1, 1});
  loop.insert(loop.begin(), loop[0]);
  EXPECT_EQ(outline(kOrigin, loop).corners, sorted(kSquare));
  const Loop bent{{-1, -1, 1}, {0, -2, 2}, {1, -1, 1}, {0, 1, 1}};  // the second is seen on the edge between its neighbours
  EXPECT_EQ(outline(kOrigin, bent).corners, sorted({bent[0], bent[2], bent[3]}));
  EXPECT_EQ(outline(kOrigin, bent).farthest, bent[1]);
  EXPECT_EQ(outline(kUp, bent).corners, sorted(bent));
}

TEST(Outline, OfAPolytopeRunsAlongTheFacesTurnedToTheViewpoint) {
  const Polytope level = cuboid({1, -1, -2}, {3, 1, 0});  // its top, z = 0, is seen edge-on
  EXPECT_EQ(outline(kOrigin, level).corners, sorted({{1, -1, -2}, {1, 1, -2}, {1, -1, 0}, {1, 1, 0}}));
  const Polytope corner = cuboid({1, 1, 1}, {3, 3, 3});
  EXPECT_EQ(outline(kOrigin, corner).corners, sorted({{3, 1, 1}, {3, 3, 1}, {1, 3, 1}, {1, 3, 3}, {1, 1, 3}, {3, 1, 3}}));
  EXPECT_EQ(outline(kOrigin, corner).farthest, (Point{3, 3, 1})) << "the first of three";
  EXPECT_EQ(outline(kUp, corner).farthest, (Point{1, 1, 1}));
  EXPECT_EQ(outline({{2, 2, 2}, false}, corner).refusal, "the eye lies in the polytope");
}

// ------------------------------------------------------------------------------------------------------------ cones of rays

Loop scaled(Loop loop, double factor) {
  for (Point& v : loop) v = {v[0] * factor, v[1] * factor, v[2] * factor};
  return loop;
}

TEST(Cones, AgreeWithCasesWorkedOutByHand) {
  const double more = above(1);
  const std::pair<Loop, Relation> cases[] = {
      {kSquare, kInside},
      {scaled(kSquare, 3), kInside},
      {scaled(kSquare, -1), kOutside},
      {{{-1, -1, 1}, {1, -1, 1}, {0, 1, 1}}, kInside},
      {{{-1, -1, 1}, {more, -1, 1}, {0, 1, 1}}, kPartial},
      {kDiamond, kPartial},
      {{{1, 1, 1}, {2, 1, 1}, {1, 2, 1}}, kPartial},
      {{{more, 1, 1}, {2, 1, 1}, {more, 2, 1}}, kOutside},
      {{{1, -1, 1}, {1, 1, 1}, {2, 0, 1}}, kPartial},
      {{{more, -1, 1}, {more, 1, 1}, {2, 0, 1}}, kOutside},
      {{{3, 0, 1}, {0, 3, 1}, {3, 3, 1}}, kOutside},
      {{{2, 0, 1}, {0, 2, 1}, {3, 3, 1}}, kPartial},
      {{{0, 0, 1}, {9, -1, -1}, {9, 1, -1}}, kPartial},
      {{{-3, 9, -1}, {-3, -9, -1}, {9, 0, -1}}, kOutside},
      {{{-9, 0, 1}, {9, 5, -9}, {9, -5, -9}}, kOutside},  // the eye is in its bounding box
  };
  for (std::size_t i = 0; i < std::size(cases); ++i) {
    const auto& [occludee, expected] = cases[i];
    const Answer answer = cone_relation(kOrigin, kSquare, occludee);
    EXPECT_EQ(answer.refusal, "") << i;
    EXPECT_EQ(answer.relation, expected) << i;
  }
  const Loop folded{{-1, -1, 1}, {1, -1, 2}, {1, 1, 3}, {-1, 1, 1}};
  EXPECT_EQ(cone_relation(kOrigin, kSquare, folded).relation, kInside);
  EXPECT_EQ(cone_relation(kOrigin, folded, kSquare).relation, kPartial);
}

TEST(Cones, OfPolytopesAndAlongADirection) {
  const Polytope block = cuboid({-1, -1, 1}, {1, 1, 3}), corner = cuboid({1, 1, 1}, {3, 3, 3});
  EXPECT_EQ(cone_relation(kOrigin, kSquare, block).relation, kInside);
  EXPECT_EQ(cone_relation(kOrigin, block, kSquare).relation, kInside);
  EXPECT_EQ(cone_relation(kOrigin, block, corner).relation, kPartial);
  EXPECT_EQ(cone_relation(kOrigin, block, cuboid({-1, -1, -3}, {1, 1, -1})).relation, kOutside);
  EXPECT_EQ(cone_relation(kUp, block, cuboid({-1, -1, -3}, {1, 1, -1})).relation, kInside);
  EXPECT_EQ(cone_relation(kUp, block, corner).relation, kPartial) << "they touch in an edge as seen";
  EXPECT_EQ(cone_relation(kUp, block, cuboid({above(1), 1, 7}, {3, 3, 9})).relation, kOutside);
  EXPECT_EQ(cone_relation(kOrigin, kSquare, Loop{{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}).refusal,
            "the eye lies in the polygon's plane");
}

// ------------------------------------------------------------------------------------------------- polytopes as occludees

TEST(Occludee, AgreesWithCasesWorkedOutByHand) {
  Shadow shadow(kOrigin, kSquare, kSurface);
  const auto ask = [&](const Point& min, const Point& max) { return shadow.relation(cuboid(min, max)).relation; };
  EXPECT_EQ(ask({-2, -2, 2}, {2, 2, 3}), kInside);
  EXPECT_EQ(ask({-2, -2, 2}, {above(2), 2, 3}), kPartial);
  EXPECT_EQ(ask({2, 0, 1}, {3, 1, 2}), kPartial);
  EXPECT_EQ(ask({2, 0, 1}, {3, 1, below(2)}), kOutside);
  EXPECT_EQ(ask({-9, -9, -9}, {9, 9, 9}), kPartial);
  EXPECT_EQ(ask({-9, -9, -9}, {9, 9, below(1)}), kOutside);
  // Its bounding box meets F. The tetrahedron itself touches only the side x = z, at (4, 0, 4), or does not meet F.
  const auto tetrahedron = [](double x) {
    return Polytope{{{x, 0, 4}, {9, 0, 3}, {9, 1, 5}, {9, -1, 5}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 2, 3}}};
  };
  EXPECT_EQ(shadow.relation(tetrahedron(4)).relation, kPartial);
  EXPECT_EQ(shadow.relation(tetrahedron(above(4))).relation, kOutside);
  Polytope open = cuboid({-1, -1, 2}, {1, 1, 3});
  open.faces.pop_back();
  EXPECT_EQ(shadow.relation(open).refusal, "the polytope is not closed");
  open.vertices[0][0] = kNan;
  EXPECT_EQ(shadow.relation(open).refusal, "a number is not finite");
}

// ------------------------------------------------------------------------------------------------------------------ unions

/// A wall at z = 1 from x = low to x = high, and y from -1 to 1.
Loop wall(double low, double high) { return {{low, -1, 1}, {high, -1, 1}, {high, 1, 1}, {low, 1, 1}}; }

TEST(Union, AgreesWithCasesWorkedOutByHand) {
  struct HandCase {
    const char* what;
    double low;  // start of the second wall, which ends at 1; the first is from -1 to 0
    Box box;
    Relation expected;
  };
  const HandCase cases[] = {
      {"in the first alone", 0, Aabb{{-2, -1, 2}, {-1, 1, 3}}, kInside},
      {"across the common edge", 0, Aabb{{-1, -1, 2}, {1, 1, 3}}, kInside},
      {"all of both", 0, Aabb{{-2, -2, 2}, {2, 2, 3}}, kInside},
      {"the same, out by an ulp", 0, Aabb{{-2, -2, 2}, {above(2), 2, 3}}, kPartial},
      {"on the near planes", 0, Aabb{{-1, -1, 1}, {1, 1, 2}}, kInside},
      {"before them", 0, Aabb{{-1, -1, below(1)}, {1, 1, 2}}, kPartial},
      {"a gap of 2^-60", 0x1p-60, Aabb{{-1, -1, 2}, {1, 1, 3}}, kPartial},
      {"walls that overlap", -0.5, Aabb{{-2, -2, 2}, {2, 2, 3}}, kInside},
      {"touching both from outside", 0, Aabb{{-1, 2, 2}, {1, 3, 2}}, kPartial},
      {"in neither", 0, Aabb{{-1, above(2), 2}, {1, 3, 2}}, kOutside},
      {"flat, in the common plane", 0, Aabb{{0, -2, 2}, {0, 2, 3}}, kInside},
      {"a diamond across", 0, Obb{{0, 0, 3}, {{{1, 1, 0}, {1, -1, 0}, {0, 0, 1}}}}, kInside},
      {"the same, wider", 0, Obb{{0, 0, 3}, {{{above(1), 1, 0}, {1, -1, 0}, {0, 0, 1}}}}, kPartial},
  };
  for (const auto& [what, low, box, expected] : cases) {
    Shadow first(kOrigin, wall(-1, 0), kSurface), second(kOrigin, wall(low, 1), kSurface);
    EXPECT_EQ(first.relation_to_union(second, box).relation, expected) << what;
    EXPECT_EQ(second.relation_to_union(first, box).relation, expected) << what;
  }
}

TEST(Union, NeedNotBeConvex) {
  // Seen from the origin, the walls are a cross of two bars. What is between their arms is in neither shadow.
  const Loop level{{-3, -1, 1}, {3, -1, 1}, {3, 1, 1}, {-3, 1, 1}}, upright{{-1, -3, 1}, {1, -3, 1}, {1, 3, 1}, {-1, 3, 1}};
  Shadow first(kOrigin, level, kSurface), second(kOrigin, upright, kSurface);
  const auto ask = [&](const Box& box) { return first.relation_to_union(second, box).relation; };
  EXPECT_EQ(ask(Aabb{{-1, -1, 1}, {1, 3, 2}}), kInside);
  EXPECT_EQ(ask(Aabb{{-3, -1, 1}, {3, 1, 1}}), kInside);
  EXPECT_EQ(ask(Obb{{1, 1, 1}, {{{1, -1, 0}, {0, 0, 0}, {0, 0, 0}}}}), kInside) << "through the inner corner";
  EXPECT_EQ(ask(Obb{{above(1), 1, 1}, {{{1, -1, 0}, {0, 0, 0}, {0, 0, 0}}}}), kPartial) << "just past it";
  EXPECT_EQ(ask(Aabb{{above(1), above(1), 1}, {2, 2, 1}}), kOutside);
}

TEST(Union, NamesTheFirstFault) {
  Shadow good(kOrigin, kSquare, kSurface), flat({{1, 1, 1}, false}, kSquare, kSurface);
  const Aabb box{{-1, -1, 2}, {1, 1, 3}};
  EXPECT_EQ(good.relation_to_union(flat, box).refusal, flat.refusal());
  EXPECT_EQ(flat.relation_to_union(good, box).refusal, flat.refusal());
  EXPECT_EQ(good.relation_to_union(flat, Aabb{{1, 1, 1}, {0, 0, 0}}).refusal, "the box has min > max");
}

// ------------------------------------------------------------------------------------------------------- culls by unions

const std::string kNotInside = "the box is not inside the union of the frusta";
const std::string kTouches = "the box touches a near plane where the other shadow does not hide it";

/// Expects the same refutation for both orders of the shadows.
void expect_refutation(const Loop& a, const Loop& b, const Box& box, const std::string& expected, const char* what) {
  Shadow first(kOrigin, a, kSurface), second(kOrigin, b, kSurface);
  EXPECT_EQ(first.refute_union_cull(second, box), expected) << what;
  EXPECT_EQ(second.refute_union_cull(first, box), expected) << what;
}

TEST(UnionCull, OfWallsInOnePlane) {
  const Loop left = wall(-1, 0), right = wall(0, 1);
  expect_refutation(left, right, Aabb{{-2, -2, 2}, {2, 2, 3}}, "", "all of both");
  expect_refutation(left, right, Aabb{{-2, -1, 2}, {-1, 1, 3}}, "", "in the first alone");
  expect_refutation(left, right, Aabb{{-2, -2, 2}, {above(2), 2, 3}}, kNotInside, "out by an ulp");
  expect_refutation(left, wall(0x1p-60, 1), Aabb{{-1, -1, 2}, {1, 1, 3}}, kNotInside, "a gap of 2^-60");
  expect_refutation(wall(-1, 0.5), wall(0.5, 1), Aabb{{-1, -1, 2}, {2, 1, 3}}, "", "no gap");
  expect_refutation(wall(-1, 0.5), wall(above(0.5), 1), Aabb{{-1, -1, 2}, {2, 1, 3}}, kNotInside, "a gap of an ulp");
  expect_refutation(left, right, Aabb{{-1, -1, 1}, {1, 1, 2}}, kTouches, "on both near planes");
  expect_refutation(left, right, Aabb{{-1, -1, 1}, {1, 1, 1}}, kTouches, "coplanar");
  expect_refutation(left, right, Aabb{{0, 0, 1}, {0, 0, 1}}, kTouches, "a point of the common edge");
  expect_refutation(left, right, Aabb{{-1, -1, above(1)}, {1, 1, 2}}, "", "beyond them by an ulp");
}

TEST(UnionCull, WhatIsOnANearPlaneMustBeBehindTheOther) {
  // The wall at z = 1 hides the half of the wall at z = 2 with x <= 0.
  const Loop front = wall(-1, 0), back{{-2, -2, 2}, {2, -2, 2}, {2, 2, 2}, {-2, 2, 2}};
  expect_refutation(front, back, Aabb{{-2, -1, 2}, {-1, 1, 3}}, "", "on the back wall, behind the front one");
  expect_refutation(front, back, Aabb{{-2, -1, 2}, {0, 1, 3}}, "", "up to the edge of what is behind the front one");
  expect_refutation(front, back, Aabb{{-2, -1, 2}, {0x1p-60, 1, 3}}, kTouches, "beyond that edge");
  expect_refutation(front, back, Aabb{{-2, -1, above(2)}, {1, 1, 3}}, "", "beyond both walls");
  // This box leaves the shadow of the front wall exactly where it goes through the back wall.
  const Box slanting = Obb{{0, 0, 2}, {{{0.5, 0, 0.25}, {0, 0, 0}, {0, 0, 0}}}};
  expect_refutation(front, back, slanting, "", "through the back wall at that edge");
  expect_refutation(front, back, Obb{{0, 0, below(2)}, {{{0.5, 0, 0.25}, {0, 0, 0}, {0, 0, 0}}}}, kNotInside,
                    "an ulp before it");
}

TEST(UnionCull, OfACornerOfTwoWalls) {
  // Two walls at a right angle meet at x = 0, z = 1. One is in x + z = 1, the other in z - x = 1. The corner points to the
  // eye.
  const Loop left{{-1, -1, 2}, {0, -1, 1}, {0, 1, 1}, {-1, 1, 2}}, right{{0, -1, 1}, {1, -1, 2}, {1, 1, 2}, {0, 1, 1}};
  expect_refutation(left, right, Aabb{{-1, -0.5, 3}, {1, 0.5, 4}}, "", "behind both");
  expect_refutation(left, right, Aabb{{-1, -0.5, 2}, {1, 0.5, 4}}, kTouches, "in the corner: touching along both ends");
  expect_refutation(left, right, Aabb{{-1, -0.5, above(2)}, {1, 0.5, 4}}, "", "in the corner, an ulp from the ends");
  expect_refutation(left, right, Aabb{{-0.5, -0.5, 1.5}, {0, 0.5, 2}}, kTouches, "an edge on the left wall");
  expect_refutation(left, right, Aabb{{-0.5, -0.5, below(1.5)}, {0, 0.5, 2}}, kNotInside, "out before the left wall");
  expect_refutation(left, right, Aabb{{0, 0, 1}, {0, 0, 2}}, kTouches, "a needle from the common edge");
  expect_refutation(left, right, Aabb{{0, 0, above(1)}, {0, 0, 2}}, "", "a needle behind it");
  const Loop apart{{0x1p-52, -1, 1}, {1, -1, 2}, {1, 1, 2}, {0x1p-52, 1, 1}};
  expect_refutation(left, apart, Aabb{{-1, -0.5, 3}, {1, 0.5, 4}}, kNotInside, "a gap of an ulp");
}

TEST(UnionCull, OfACornerTurnedAway) {
  // The walls meet at x = 0, z = 2, farthest from the eye. A needle goes behind the left wall and then behind the right one.
  // In between it touches both.
  const Loop left{{-1, -1, 1}, {0, -1, 2}, {0, 1, 2}, {-1, 1, 1}}, right{{0, -1, 2}, {1, -1, 1}, {1, 1, 1}, {0, 1, 2}};
  const auto needle = [](double z) { return Aabb{{-0.5, 0, z}, {0.5, 0, z}}; };
  expect_refutation(left, right, needle(2), kTouches, "through the corner");
  expect_refutation(left, right, needle(above(2)), "", "behind it");
  expect_refutation(left, right, needle(below(2)), kNotInside, "before it");
}

TEST(UnionCull, OfABlockAndAWall) {
  const Polytope block = cuboid({-1, -1, 1}, {0, 1, 3});
  Shadow first(kOrigin, block, kSurface), second(kOrigin, wall(0, 1), kSurface);
  EXPECT_EQ(first.refute_union_cull(second, Aabb{{-2, -1, 2}, {1, 1, 3}}), "");
  EXPECT_EQ(second.refute_union_cull(first, Aabb{{-1, -1, 1}, {0.5, 1, 3}}), kTouches);
  EXPECT_EQ(second.refute_union_cull(first, Aabb{{-2, -1, 2}, {above(2), 1, 3}}), kNotInside);
}

TEST(UnionCull, NamesFaults) {
  const Loop bent{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1.5}, {-1, 1, 1}};
  const Aabb box{{-1, -1, 2}, {1, 1, 3}};
  Shadow good(kOrigin, kSquare, kSurface), unsound(kOrigin, bent, {Near::Kind::plane, {0, 0, 1}, {0, 0, 1.25}});
  EXPECT_NE(unsound.refusal(), "");
  EXPECT_EQ(good.refute_union_cull(unsound, box), unsound.refusal());
  EXPECT_EQ(unsound.refute_union_cull(good, box), unsound.refusal());
  EXPECT_EQ(good.refute_union_cull(good, Aabb{{1, 1, 1}, {0, 0, 0}}), "the box has min > max");
}

}  // namespace questions_test
}  // namespace occlude::oracle
