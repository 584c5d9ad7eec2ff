// SPDX-License-Identifier: MIT
// Witnesses of culls that hold for a region of eyes: cases worked out by hand, exact lines of sight, and copies of scenes.
#include "occlude/oracle/region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "occlude/oracle/cover.h"
#include "occlude/oracle/second.h"
#include "oracle/cuboid.h"
#include "oracle/region_scenes.h"
#include "oracle/vocabulary.h"

namespace occlude::oracle {
namespace region_test {

using Polygons = std::vector<Loop>;

/// A rectangle across the x axis.
Loop wall(double x, double y0, double y1, double z0, double z1) {
  return {{x, y0, z0}, {x, y1, z0}, {x, y1, z1}, {x, y0, z1}};
}

/// A square around the x axis.
Loop wall(double x, double half) { return wall(x, -half, half, -half, half); }

/// Across the x axis. Its axes are -y and z.
Focus focus(double x) { return {{x, 0, 0}, {1, 0, 0}, {0, -1, 0}}; }

Window window(double y0, double y1, double z0, double z1, const Sheet& sheet) { return {-y1, z0, -y0, z1, sheet}; }

Window window(double half, const Sheet& sheet) { return window(-half, half, -half, half, sheet); }

/// The eyes are a square around the origin, |y|, |z| <= 1, the box is 6 <= x <= 8, |y|, |z| <= 1. On a focus plane at x = 4
/// this is seen through the square |y|, |z| <= 1; there, and at every smaller x, lines through that square fill it.
RegionWitness square_and_cube(double focus_at, const std::vector<Window>& windows) {
  return {Obb{{0, 0, 0}, {{{0, 1, 0}, {0, 0, 1}, {0, 0, 0}}}}, Aabb{{6, -1, -1}, {8, 1, 1}}, {focus(focus_at), windows}};
}

std::string verdict(const RegionWitness& witness) { return judge(witness).reason; }

const std::string kUncovered = "the windows do not cover what the box is seen through";
const std::string kBefore = "the border of the sheet shows before the focus plane";
const std::string kBeyond = "the border of the sheet shows beyond the focus plane";
const std::string kNotNearer = "the sheet reaches the depth of the box";
const std::string kEven = "the sheet is met an even number of times";

std::string in_window(int i, const std::string& fault) { return "window " + std::to_string(i) + ": " + fault; }

TEST(Region, OneWallInFocus) {
  const auto of = [](double half_wall, double half_window) {
    return verdict(square_and_cube(4, {window(half_window, Sheet({wall(4, half_wall)}))}));
  };
  EXPECT_EQ(of(2, 1), "") << "what is seen through the border of a window is seen through it";
  EXPECT_EQ(of(2, below(1)), kUncovered);
  EXPECT_EQ(of(above(1), 1), "");
  EXPECT_EQ(of(1, 1), in_window(0, kBefore)) << "the border touches the window";
}

TEST(Region, AWallOutOfFocus) {
  const auto at = [](double x, double half) { return verdict(square_and_cube(2, {window(1, Sheet({wall(x, half)}))})); };
  EXPECT_EQ(at(1, above(1)), "");
  EXPECT_EQ(at(1, 1), in_window(0, kBefore));
  EXPECT_EQ(at(4, above(3)), "") << "an eye at -1 sees y = 3 there through y = 1";
  EXPECT_EQ(at(4, 3), in_window(0, kBeyond));
}

/// An eye at 1 sees y = -1 of the nearest face through y = 1 + 10 / 6 * -2 = -7 / 3 at x = 10.
TEST(Region, TheFocusPlaneBehindTheBox) {
  const double seventh = 7. / 3;
  ASSERT_GT(3 * seventh - 7, -1e-15);
  const auto of = [](double half_window, double half_wall) {
    return verdict(square_and_cube(10, {window(half_window, Sheet({wall(5, half_wall)}))}));
  };
  EXPECT_EQ(of(2.5, 2), "") << "lines through the window reach (1 + 2.5) / 2 halfway";
  EXPECT_EQ(of(2.5, 1.75), in_window(0, kBefore));
  EXPECT_EQ(of(2.5, above(1.75)), "");
  const double covers = 3 * (seventh - 2) >= 1 ? seventh : above(seventh);
  EXPECT_EQ(of(covers, 2), "");
  EXPECT_EQ(of(below(covers), 2), kUncovered);
}

/// Through -1 <= y <= 0 at x = 4, eyes see -1 <= y <= 1/4 at x = 3; through 0 <= y <= 1 they see -1/4 <= y <= 3/2 at x = 5.
TEST(Region, TwoWindowsOfTwoWalls) {
  const auto of = [](double right_end, double left_end) {
    return verdict(square_and_cube(4, {window(-1, 0, -1, 1, Sheet({wall(3, -2, right_end, -2, 2)})),
                                       window(0, 1, -1, 1, Sheet({wall(5, left_end, 2, -2, 2)}))}));
  };
  EXPECT_EQ(of(above(0.25), below(-0.25)), "");
  EXPECT_EQ(of(0.25, -0.5), in_window(0, kBefore));
  EXPECT_EQ(of(0.5, -0.25), in_window(1, kBeyond));
}

TEST(Region, WindowsThatCoverTogether) {
  const Sheet sheet({wall(4, 2)});
  const auto of = [&](const std::vector<Window>& windows) { return verdict(square_and_cube(4, windows)); };
  const Window low = window(-1, 1, -1, 0, sheet), left = window(-1, 0, 0, 1, sheet), right = window(0, 1, 0, 1, sheet);
  EXPECT_EQ(of({low, left, right}), "");
  EXPECT_EQ(of({right, left, low}), "");
  EXPECT_EQ(of({low, left}), kUncovered);
  EXPECT_EQ(of({left, right}), kUncovered);
  EXPECT_EQ(of({}), kUncovered);
  EXPECT_EQ(of({low, left, window(0, 1, 0.5, 1, sheet), window(0, 1, 0, below(0.5), sheet)}), kUncovered) << "a slit";
  EXPECT_EQ(of({low, left, window(0, 1, 0.5, 1, sheet), window(0, 1, 0, 0.5, sheet), window(0, 0.1, 0, 0.1, sheet)}), "");
  EXPECT_EQ(of({window(-1, 1, -1, -0.5, sheet), window(-1, 1, 0.5, 1, sheet), window(-1, -0.5, -0.5, 0.5, sheet),
                window(0.5, 1, -0.5, 0.5, sheet)}),
            kUncovered)
      << "a ring";
}

/// What is seen through |y|, |z| <= 1 at x = 4 is seen through the same square at x = 2, where the eyes see the left half of
/// the square at x = 4 through -1 <= y <= 1/2.
TEST(Region, ALayerBehindAnother) {
  const auto of = [](double end, double end_of_wall) {
    const Layer near{focus(2), {window(-1, end, -1, 1, Sheet({wall(2, -2, end_of_wall, -2, 2)}))}};
    Window left = window(-1, 0, -1, 1, Sheet(Polygons{})), right = window(0, 1, -1, 1, Sheet({wall(4.5, -1, 2, -2, 2)}));
    left.to = near;
    return verdict(square_and_cube(4, {left, right}));
  };
  EXPECT_EQ(of(0.5, 1), "");
  EXPECT_EQ(of(below(0.5), 1), in_window(0, kUncovered));
  EXPECT_EQ(of(0.5, 0.5), in_window(0, in_window(0, kBefore)));
  RegionWitness witness = square_and_cube(4, {window(1, Sheet({wall(4, 2)}))});
  witness.layer.windows[0].to = Layer{focus(0), {}};
  EXPECT_EQ(verdict(witness), in_window(0, "the eyes reach the focus plane"));
  witness.layer.windows[0].to = Layer{focus(5), {window(1.25, Sheet({wall(3, 2)}))}};
  EXPECT_EQ(verdict(witness), in_window(0, kUncovered)) << "the square at x = 5 is |y|, |z| <= 3/2";
  witness.layer.windows[0].to = Layer{focus(5), {window(1.5, Sheet({wall(3, 2)}))}};
  EXPECT_EQ(verdict(witness), "");
  witness.layer.windows[0].to = Layer{focus(5), {window(1.5, Sheet({wall(7, 9)}))}};
  EXPECT_EQ(verdict(witness), in_window(0, in_window(0, kEven))) << "behind the box";
  // Along (1, 1, 0) an eye is at 1, and the window from y = -4 on begins at 0.
  witness.layer.windows[0] = window(-4, 1, -1, 1, Sheet({wall(4, 9)}));
  EXPECT_EQ(verdict(witness), "");
  witness.layer.windows[0].to = Layer{{{3, 0, 0}, {1, 1, 0}, {1, -1, 0}}, {window(9, Sheet({wall(3, 20)}))}};
  EXPECT_EQ(verdict(witness), in_window(0, "the eyes reach the depth of the box"));
}

/// The eye and the box are points, so one line is all.
TEST(Region, PointsAreRegions) {
  const Obb eye{{0, 0, 0}, {}};
  const Sheet sheet({wall(4, 2)});
  const auto of = [&](double y, double half) {
    const Aabb box{{8, y, 0}, {8, y, 0}};
    return verdict({eye, box, {focus(4), {window(half, sheet)}}});
  };
  EXPECT_EQ(of(2, 1), "");
  EXPECT_EQ(of(above(2), 1), kUncovered);
  EXPECT_EQ(verdict({Ball{}, Aabb{{8, 0, 0}, {8, 0, 0}}, {focus(4), {window(1, sheet)}}}), "");
}

/// Both ends of an edge are outside of what eyes see through |y| <= 1/2: at x = 1 that is |y| <= 7/8, at x = 3 it is 5/8.
TEST(Region, AnEdgeBetweenEndsThatAreAside) {
  const auto of = [](double y0, double y1) {
    const Loop triangle{{1, y0, 0}, {3, y1, 0}, {2, 9, 9}};
    return verdict({Obb{{0, 0, 0}, {{{0, 1, 0}, {0, 0, 1}, {0, 0, 0}}}},
                    Aabb{{8, 0, 0}, {8, 0, 0}},
                    {focus(4), {window(-0.5, 0.5, -0.5, 0.5, Sheet({triangle, wall(2, 9)}))}}});
  };
  EXPECT_EQ(of(1, -1), in_window(0, kBefore));
  EXPECT_EQ(of(1, 1), "");
  EXPECT_EQ(of(-1, -1), in_window(0, kBefore)) << "its other edges";
}

/// The eyes are -1 <= x <= 1 on the x axis. The edge of a wall at x = 2, z = 1/10, |y| <= 1 is seen at x = 10 from -1 at z =
/// 11/30, |y| <= 11/3, and from 1 at z = 9/10, |y| <= 9. The x axis, towards which the eyes move, passes under its middle.
TEST(Region, AnEdgeAcrossTheWayOfTheEyes) {
  const auto of = [](double z, double z0, double z1) {
    const Obb eyes{{0, 0, 0}, {{{1, 0, 0}, {0, 0, 0}, {0, 0, 0}}}};
    return verdict(
        {eyes, Aabb{{12, 0, z}, {12, 0, z}}, {focus(10), {window(-0.1, 0.1, z0, z1, Sheet({wall(2, -1, 1, 0.1, 5)}))}}});
  };
  EXPECT_EQ(of(0.78, 0.6, 0.7), in_window(0, kBefore)) << "between the images from both ends";
  EXPECT_EQ(of(0.3, 0.2, 0.3), in_window(0, kEven));
  EXPECT_EQ(of(1.25, 0.9375, 1.25), "");
}

/// The same wall, but one end of its edge is nearer: at z = 1/10 from (1.5, -1) to (3, 1). From 1 the near end is seen at (x
/// = 10) y = -18, z = 1.8, the far one at y = 4.5, z = .45; from -1 at -4.4, .44 and 2.75, .275. Where the edge crosses y =
/// 0, it is at x = 2.25, seen at z = .72 and .3385.
TEST(Region, AnEdgeWithOneEndNearer) {
  const auto of = [](double z, double z0, double z1) {
    const Obb eyes{{0, 0, 0}, {{{1, 0, 0}, {0, 0, 0}, {0, 0, 0}}}};
    const Loop slanting{{1.5, -1, 0.1}, {3, 1, 0.1}, {3, 1, 5}, {1.5, -1, 5}};
    return verdict({eyes, Aabb{{12, 0, z}, {12, 0, z}}, {focus(10), {window(-0.01, 0.01, z0, z1, Sheet({slanting}))}}});
  };
  EXPECT_EQ(of(0.75, 0.6, 0.7), in_window(0, kBefore));
  EXPECT_EQ(of(0.75, 0.6, 0.75), in_window(0, kBefore));
  EXPECT_EQ(of(0.92, 0.74, 0.8), "");
  EXPECT_EQ(of(0.35, 0.28, 0.3), in_window(0, kEven));
}

TEST(Region, NearerThanTheBox) {
  const auto at = [](double x) { return verdict(square_and_cube(4, {window(1, Sheet({wall(x, 9)}))})); };
  EXPECT_EQ(at(below(6)), "");
  EXPECT_EQ(at(6), in_window(0, kNotNearer));
  EXPECT_EQ(at(7), in_window(0, kEven));
  EXPECT_EQ(at(9), in_window(0, kEven));
  EXPECT_EQ(verdict(square_and_cube(4, {window(1, Sheet({wall(3, 9), wall(7, 9)}))})), "");
  EXPECT_EQ(verdict(square_and_cube(4, {window(1, Sheet({wall(3, 9), wall(6, 9)}))})), in_window(0, kNotNearer));
}

TEST(Region, ModuloTwo) {
  const auto of = [](const Polygons& polygons) { return verdict(square_and_cube(4, {window(1, Sheet(polygons))})); };
  EXPECT_EQ(of({wall(3, 9), wall(4, 9)}), in_window(0, kEven));
  EXPECT_EQ(of({wall(3, 9), wall(4, 9), wall(5, 9)}), "");
  EXPECT_EQ(of({wall(3, 9), wall(3, 9)}), in_window(0, kEven));
  EXPECT_EQ(of({}), in_window(0, kEven));
  EXPECT_EQ(of({wall(3, -9, 0, -9, 9), wall(3, 0, 9, -9, 9)}), "") << "they share an edge";
  EXPECT_EQ(of({wall(3, -9, 0, -9, 9), wall(3, 0, 9, -9, 0), wall(3, 0, 9, 0, 9)}), in_window(0, kBefore))
      << "one edge runs along two";
  const Loop fin{{3, 0, -9}, {3, 0, 9}, {2, 0, 9}, {2, 0, -9}};
  EXPECT_EQ(of({wall(3, -9, 0, -9, 9), wall(3, 0, 9, -9, 9), fin}), in_window(0, kBefore)) << "three share an edge";
}

/// z = 2 (x - 2) for 1 <= x <= 3. Lines of sight cross it between x = 1.6 and 2.4: an eye at 1 through -1 at x = 4 is at 1 -
/// x / 2 there.
TEST(Region, WhatIsBeforeTheNearPlaneDoesNotCount) {
  const Loop slope{{1, -9, -2}, {1, 9, -2}, {3, 9, 2}, {3, -9, 2}};
  const auto from = [&](double x) {
    return verdict(square_and_cube(4, {window(1, Sheet({slope}, HalfSpaceCoefficients{1, 0, 0, -x}))}));
  };
  EXPECT_EQ(from(1), "");
  EXPECT_EQ(from(below(1.5)), "") << "the lowest line is at z = -1";
  EXPECT_EQ(from(1.5), in_window(0, kBefore));
  EXPECT_EQ(from(2), in_window(0, kBefore));
  EXPECT_EQ(from(2.5), in_window(0, kBefore));
  EXPECT_EQ(from(above(2.5)), in_window(0, kEven));
}

TEST(Region, ABorderOnTheNearPlane) {
  const Loop slope{{1.75, -9, -0.5}, {1.75, 9, -0.5}, {3, 9, 2}, {3, -9, 2}};
  const auto from = [&](double x) {
    return verdict(square_and_cube(4, {window(1, Sheet({slope}, HalfSpaceCoefficients{1, 0, 0, -x}))}));
  };
  for (const double x : {1., 1.75, 2.}) EXPECT_EQ(from(x), in_window(0, kBefore)) << x;
}

/// Of two halves of a wall one is before the near plane, and the plane passes through the edge that they share.
TEST(Region, WhatTheNearPlaneLeavesHasABorder) {
  const Loop half{{3, -9, -9}, {3, 0, -9}, {3, 0, 9}, {3, -9, 9}}, other{{2, 9, -9}, {3, 0, -9}, {3, 0, 9}, {2, 9, 9}};
  const auto from = [&](double x) {
    return verdict(square_and_cube(4, {window(1, Sheet({half, other}, HalfSpaceCoefficients{1, 0, 0, -x}))}));
  };
  EXPECT_EQ(from(2), "");
  EXPECT_EQ(from(2.5), "");
  EXPECT_EQ(from(3), in_window(0, kBefore));
}

/// A closed box of which one face is in the near plane: lines meet it twice or not at all.
TEST(Region, AFaceInTheNearPlane) {
  const Polytope solid = cuboid({2, -0.75, -0.75}, {3, 0.75, 0.75});
  Polygons faces;
  for (const auto& face : solid.faces) {
    Loop& loop = faces.emplace_back();
    for (const std::uint32_t i : face) loop.push_back(solid.vertices[i]);
  }
  const auto of = [&](const Polygons& polygons, double x) {
    return verdict(square_and_cube(4, {window(1, Sheet(polygons, HalfSpaceCoefficients{1, 0, 0, -x}))}));
  };
  for (const double x : {1., 2.}) EXPECT_EQ(of(faces, x), in_window(0, kEven)) << x;
  EXPECT_EQ(of(faces, above(2)), in_window(0, kBefore));
  EXPECT_EQ(of({wall(2, 9)}, 2), "");
}

TEST(Region, EyesMustBeBeforeEverything) {
  RegionWitness witness = square_and_cube(4, {window(1, Sheet({wall(3, 9), wall(0, 9)}))});
  EXPECT_EQ(judge(witness).reason, "window 0: the eyes touch the sheet");
  EXPECT_EQ(judge(witness).fault, RegionFault::eyes_at_sheet);
  witness.layer.windows[0].to = Sheet({wall(3, 9), wall(0, 9)}, HalfSpaceCoefficients{1, 0, 0, below(0)});
  witness.layer.windows[0].to = Sheet({wall(3, 9), wall(0, 9)}, HalfSpaceCoefficients{1, 0, 0, -0.125});
  EXPECT_EQ(verdict(witness), "");
  witness.layer.focus = focus(0);
  EXPECT_EQ(verdict(witness), "the eyes reach the focus plane");
  witness.layer.focus = focus(-1);
  EXPECT_EQ(verdict(witness), "the eyes reach the focus plane");
  witness.layer.focus = focus(4);
  witness.box = Aabb{{0, 5, 5}, {1, 6, 6}};
  EXPECT_EQ(verdict(witness), "the eyes reach the depth of the box");
}

/// 3 x + 4 y = 5 touches the unit ball at (3/5, 4/5) and goes through (2, -1/4), (3, -1) and (7, -4).
TEST(Region, ABallAndItsTangents) {
  const auto of = [](double right_end, const Loop& polygon) {
    return verdict(
        {Ball{{0, 0, 0}, 1}, Aabb{{7, -4, 0}, {7, -4, 0}}, {focus(3), {window(-4, right_end, -1, 1, Sheet({polygon}))}}});
  };
  EXPECT_EQ(of(-1, wall(2, 9)), "");
  EXPECT_EQ(of(below(-1), wall(2, 9)), kUncovered);
  const double hair = 0x1p-30;
  EXPECT_EQ(of(-1, wall(2, -9, -0.25 + hair, -9, 9)), "");
  EXPECT_EQ(of(-1, wall(2, -9, -0.25, -9, 9)), in_window(0, kBefore));
  EXPECT_EQ(of(-1, wall(2, -9, -0.25 - hair, -9, 9)), in_window(0, kBefore));
}

/// Beyond x = 3 lines through y = 3 from the unit ball reach the line through (3, 3) that touches it at the other side: 4 x
/// - 3 y = 3 goes through (3, 3) and (6, 7), but is 3/5 from the origin; so the radius is 3/5.
TEST(Region, ABallBeyondTheFocusPlane) {
  const auto of = [](double end) {
    return verdict({Ball{{0, 0, 0}, 0.6},
                    Aabb{{8, 0, 0}, {8, 0, 0}},
                    {focus(3), {window(-3, 3, -3, 3, Sheet({wall(6, -9, end, -9, 9)}))}}});
  };
  ASSERT_LT(0.6, 0.6L + 1e-17L);
  EXPECT_EQ(of(7 + 1e-9), "");
  EXPECT_EQ(of(7 - 1e-9), in_window(0, kBeyond));
}

/// The first triangle is far above the ball, the second is in what the ball sees through |y| <= 1/2 at x = 3, but above
/// that.
TEST(Region, WhatIsAboveTheMiddleOfABallIsNotAboveTheBall) {
  const Loop far{{0.5, 5, -1}, {0.5, 5, 1}, {0.5, 6, 0}};
  const auto of = [&](double y) {
    const Loop near{{1.25, y, -1}, {1.25, y, 1}, {1.25, 5, 0}};
    return verdict(
        {Ball{{0, 0, 0}, 1}, Aabb{{5, 0, 0}, {5, 0, 0}}, {focus(3), {window(0.5, Sheet({far, near, wall(4, 9)}))}}});
  };
  EXPECT_EQ(of(0.75), in_window(0, kBefore));
  EXPECT_EQ(of(1), "");
}

/// At x = 6 the eyes see |y| <= 4 through the first window and 2 <= y <= 7 through the second. Above 6 is above the one and
/// within the other.
TEST(Region, WhatIsAboveOneWindowIsNotAboveTheNext) {
  const auto polygons = [](double y) { return Polygons{wall(3, 9), {{6, y, -1}, {6, y, 1}, {6, 9, 0}}}; };
  const auto of = [&](double y) {
    return verdict(
        {Obb{{0, 0, 0}, {{{0, 0.5, 0}, {0, 0, 0}, {0, 0, 0}}}},
         Aabb{{8, 1, 0}, {8, 1, 0}},
         {focus(2),
          {window(-0.25, 1, -0.125, 0.125, Sheet(polygons(6))), window(1, 2, -0.125, 0.125, Sheet(polygons(y)))}}});
  };
  EXPECT_EQ(of(6.75), in_window(1, kBeyond));
  EXPECT_EQ(of(7), in_window(1, kBeyond));
  EXPECT_EQ(of(above(7)), "");
}

TEST(Region, RefusesBadNumbers) {
  const auto reason = [](auto change) {
    RegionWitness witness = square_and_cube(4, {window(1, Sheet({wall(4, 2)}))});
    change(witness);
    const RegionVerdict verdict = judge(witness);
    EXPECT_EQ(verdict.fault, RegionFault::refused);
    return verdict.reason;
  };
  EXPECT_EQ(reason([](RegionWitness& w) { w.eyes = Ball{{0, 0, 0}, -1}; }), "the radius is negative");
  EXPECT_EQ(reason([](RegionWitness& w) { w.eyes = Ball{{0, 0, 0}, kNan}; }), "a number is not finite");
  EXPECT_EQ(reason([](RegionWitness& w) { w.eyes = Ball{{0, 0, 0}, kInfinity}; }), "a number is not finite");
  EXPECT_EQ(reason([](RegionWitness& w) {
              w.eyes = Obb{{0, 0, 0}, {{{0x1p101, 0, 0}, {}, {}}}};
            }),
            "a coordinate is out of range");
  EXPECT_EQ(reason([](RegionWitness& w) { w.box = Aabb{{6, 0, 0}, {5, 1, 1}}; }), "the box has min > max");
  EXPECT_EQ(reason([](RegionWitness& w) { w.layer.focus.right = w.layer.focus.normal; }), "the focus plane has no axes");
  EXPECT_EQ(reason([](RegionWitness& w) { w.layer.focus.normal = {}; }), "the focus plane has no axes");
  EXPECT_EQ(reason([](RegionWitness& w) { w.layer.focus.point[0] = kNan; }), "a number is not finite");
  EXPECT_EQ(reason([](RegionWitness& w) { w.layer.windows[0].x0 = 1; }), "a window is empty");
  EXPECT_EQ(reason([](RegionWitness& w) { w.layer.windows[0].x0 = -kInfinity; }), "a number is not finite");
  EXPECT_EQ(reason([](RegionWitness& w) {
              w.layer.windows[0].to = Sheet({{{1, 1, 1}, {2, 2, 2}}});
            }),
            "a polygon has fewer than 3 vertices");
  EXPECT_EQ(reason([](RegionWitness& w) {
              w.layer.windows[0].to = Sheet({wall(4, 2)}, HalfSpaceCoefficients{kNan, 0, 0, 0});
            }),
            "a number is not finite");
}

/// What is proved to be hidden is hidden from each eye that is tried, as the judge of single eyes finds it.
TEST(Region, WhatIsProvedIsHiddenOnExactLines) {
  std::map<RegionFault, int> count;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    RegionScenes scenes(seed);
    const RegionScene scene = scenes.next();
    const RegionFault fault = judge(scene.witness()).fault;
    ++count[fault];
    if (fault != RegionFault::none) continue;
    Polygons polygons;
    for (const Polygons& sheet : scene.sheets) polygons.insert(polygons.end(), sheet.begin(), sheet.end());
    for (int i = 0; i < 50; ++i) {
      const Point e = scenes.eye(scene.eyes), b = scenes.point(scene.box);
      ASSERT_EQ(relation_to_cover({e}, polygons, Aabb{b, b}, scene.drawn).relation, kInside)
          << seed << ": from " << e[0] << ' ' << e[1] << ' ' << e[2] << " to " << b[0] << ' ' << b[1] << ' ' << b[2];
    }
  }
  EXPECT_GT(count[RegionFault::none], 500);
  for (const RegionFault fault : {RegionFault::uncovered, RegionFault::eyes_at_sheet, RegionFault::border_before,
                                  RegionFault::border_beyond, RegionFault::not_nearer, RegionFault::even}) {
    EXPECT_GT(count[fault], 5) << static_cast<int>(fault);
  }
}

/// Axes exchanged, one reversed, a power of two as the scale, and whole numbers added: all of it is exact.
struct Copy {
  std::array<std::size_t, 3> axes;
  std::size_t mirrored;  ///< this axis; none if it is 3
  double scale;
  Point place;

  [[nodiscard]] bool turns_over() const {
    const bool is_even = axes[1] == (axes[0] + 1) % 3;
    return is_even == (mirrored < 3);
  }
  [[nodiscard]] Point vector(const Point& v) const {
    Point result{};
    for (std::size_t k = 0; k < 3; ++k) result[k] = (k == mirrored ? -1 : 1) * scale * v[axes[k]];
    return result;
  }
  [[nodiscard]] Point point(const Point& p) const { return plus(vector(p), 1, place); }
};

RegionScene copy(const RegionScene& scene, const Copy& how) {
  RegionScene result = scene;
  if (Ball* ball = std::get_if<Ball>(&result.eyes)) *ball = {how.point(ball->center), how.scale * ball->radius};
  if (Obb* box = std::get_if<Obb>(&result.eyes)) {
    box->center = how.point(box->center);
    for (Point& half_edge : box->half_edges) half_edge = how.vector(half_edge);
  }
  const Point a = how.point(scene.box.min), b = how.point(scene.box.max);
  for (std::size_t k = 0; k < 3; ++k) result.box.min[k] = std::min(a[k], b[k]), result.box.max[k] = std::max(a[k], b[k]);
  if (scene.drawn) {
    const auto& [x, y, z, offset] = *scene.drawn;
    const Point normal = plus({}, 1 / how.scale, how.vector({x, y, z}));
    result.drawn = HalfSpaceCoefficients{normal[0], normal[1], normal[2], how.scale * offset - dot(normal, how.place)};
  }
  for (Polygons& sheet : result.sheets) {
    for (Loop& loop : sheet) {
      for (Point& corner : loop) corner = how.point(corner);
    }
  }
  for (SceneLayer& layer : result.layers) {
    auto& [point, normal, right] = layer.focus;
    layer.focus = {how.point(point), how.vector(normal), how.vector(right)};
    // The second axis is a product of two vectors.
    for (auto& [x0, y0, x1, y1] : layer.rectangles) {
      if (how.turns_over()) y0 = -std::exchange(y1, -y0);
      for (double* y : {&y0, &y1}) *y /= how.scale;
    }
  }
  return result;
}

TEST(Region, CopiesHaveTheVerdictOfTheOriginal) {
  const std::vector<Copy> copies{{{1, 2, 0}, 3, 1, {}},
                                 {{0, 1, 2}, 0, 1, {}},
                                 {{0, 1, 2}, 1, 1, {}},
                                 {{2, 1, 0}, 0, 0x1p-60, {}},
                                 {{0, 1, 2}, 3, 0x1p60, {}},
                                 {{0, 1, 2}, 3, 1, {4096, -512, 8}},
                                 {{1, 0, 2}, 3, 4, {-64, 96, 1 << 20}}};
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const RegionScene scene = RegionScenes(seed).next();
    const RegionVerdict verdict = judge(scene.witness());
    for (std::size_t i = 0; i < copies.size(); ++i) {
      EXPECT_EQ(judge(copy(scene, copies[i]).witness()).reason, verdict.reason) << seed << ", copy " << i;
    }
    const auto& [low, high] = scene.box;
    Obb oriented{plus(low, 0.5, plus(high, -1, low)), {}};
    for (std::size_t k = 0; k < 3; ++k) oriented.half_edges[k][k] = (high[k] - low[k]) / 2;
    RegionWitness witness = scene.witness();
    witness.box = oriented;
    EXPECT_EQ(judge(witness).reason, verdict.reason) << seed << ", oriented";
  }
}

TEST(Region, BothOraclesAgree) {
  int boxes = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const RegionWitness witness = RegionScenes(seed).next().witness();
    if (std::holds_alternative<Ball>(witness.eyes)) continue;
    const RegionVerdict first = judge(witness);
    if (first.fault == RegionFault::refused) continue;
    const RegionVerdict second = second::judge(witness);
    EXPECT_EQ(first.fault, second.fault) << seed;
    EXPECT_EQ(first.window, second.window) << seed;
    ++boxes;
  }
  EXPECT_GT(boxes, 200);
}

/// The second oracle knows no balls, but hulls of points on one: what is hidden from the ball is hidden from these, and what
/// is hidden from such points 1 / 0.88 as far away is hidden from the ball, which is in their hull: its faces are 0.8865 of
/// the way.
TEST(Region, ABallIsBetweenTwoHulls) {
  const auto points = [](const Ball& ball, double factor) {
    std::vector<Point> result;
    for (int i = 0; i < 27; ++i) {
      const Point direction{i % 3 - 1., i / 3 % 3 - 1., i / 9 - 1.};
      const double length = std::sqrt(dot(direction, direction));
      if (length > 0) result.push_back(plus(ball.center, factor * ball.radius / length, direction));
    }
    return result;
  };
  int proved = 0, unproved = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    const RegionWitness witness = RegionScenes(seed).next().witness();
    const Ball* ball = std::get_if<Ball>(&witness.eyes);
    const RegionFault fault = judge(witness).fault;
    if (!ball || ball->radius == 0 || fault == RegionFault::refused) continue;
    const bool is_proved = fault == RegionFault::none;
    const bool of_inner = second::judge(witness, points(*ball, 1 - 0x1p-50)).is_proved();
    const bool of_outer = second::judge(witness, points(*ball, 1 / 0.88)).is_proved();
    EXPECT_LE(of_outer, is_proved) << seed;
    EXPECT_LE(is_proved, of_inner) << seed;
    ++(is_proved ? proved : unproved);
  }
  EXPECT_GT(proved, 10);
  EXPECT_GT(unproved, 10);
}

}  // namespace region_test
}  // namespace occlude::oracle
