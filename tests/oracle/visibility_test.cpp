// SPDX-License-Identifier: MIT
// Exact visibility: scenes with known answers, and random scenes against points sampled on every triangle.
#include "occlude/oracle/visibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "occlude/fuzz/random.h"

namespace visibility_test {

using namespace occlude;
using namespace occlude::oracle;

using Triangles = std::vector<Triangle>;
using Visible = std::vector<bool>;

const Viewpoint kOrigin{{0, 0, 0}};
const Viewpoint kAlongX{{1, 0, 0}, true};

/// The rectangle at this x, from (y0, z0) to (y1, z1), as two triangles.
void add_wall(Triangles& scene, double x, double y0, double y1, double z0, double z1) {
  scene.push_back({{{x, y0, z0}, {x, y1, z0}, {x, y1, z1}}});
  scene.push_back({{{x, y0, z0}, {x, y1, z1}, {x, y0, z1}}});
}

TEST(Visibility, AWallHidesWhatIsBehindIt) {
  Triangles scene;
  add_wall(scene, 2, -1, 1, -1, 1);
  add_wall(scene, 4, -2, 2, -2, 2);       // exactly the same directions
  add_wall(scene, 6, -3, 3.0625, -3, 3);  // a strip of it is beside them
  for (const Viewpoint& view : {kOrigin, Viewpoint{{-1, 0, 0}}}) {
    const bool is_origin = view.value == kOrigin.value;
    EXPECT_EQ(visible_triangles(view, scene, {}), (Visible{true, true, !is_origin, !is_origin, true, true}));
  }
  EXPECT_EQ(visible_triangles(kAlongX, scene, {}), Visible(6, true))
      << "seen in parallel each is larger than the one before";
  std::ranges::reverse(scene);
  EXPECT_EQ(visible_triangles(kOrigin, scene, {}), (Visible{true, true, false, false, true, true}));
}

TEST(Visibility, WallsThatMeetLeaveNoGapAndOneUlpIsOne) {
  for (const Viewpoint& view : {kOrigin, kAlongX}) {
    for (const double edge : {1.0 / 3, std::nextafter(1.0 / 3, 1)}) {
      Triangles scene;
      add_wall(scene, 2, -1, 1.0 / 3, -1, 1);
      add_wall(scene, 2, edge, 1, -1, 1);
      add_wall(scene, 3, -0.75, 0.75, -0.75, 0.75);
      const bool is_gap = edge > 1.0 / 3;
      EXPECT_EQ(visible_triangles(view, scene, {}), (Visible{true, true, true, true, is_gap, is_gap}));
    }
  }
}

TEST(Visibility, CrossingAndCyclicOnesAllShow) {
  const Triangle across{{{2, -1, -1}, {4, 1, -1}, {3, 0, 1}}}, other{{{2, 1, -1}, {4, -1, -1}, {3, 0, 1}}};
  EXPECT_EQ(visible_triangles(kOrigin, Triangles{across, other}, {}), (Visible{true, true}));
  EXPECT_EQ(visible_triangles(kAlongX, Triangles{across, other}, {}), (Visible{true, true}));
  // Each of the three bars is in front of the next.
  Triangles cycle;
  for (int i = 0; i < 3; ++i) {
    const double a = i * 2 * M_PI / 3, c = std::cos(a), s = std::sin(a);
    const auto at = [&](double depth, double u, double v) { return Point{depth, u * c - v * s, u * s + v * c}; };
    cycle.push_back({{at(4, -3, 0.5), at(6, 3, 0.4), at(6, 3, 0.6)}});
  }
  EXPECT_EQ(visible_triangles(kAlongX, cycle, {}), Visible(3, true));
}

TEST(Visibility, InOnePlaneNoneHidesAnotherAndEdgeOnNothingShows) {
  Triangles scene;
  add_wall(scene, 2, -1, 1, -1, 1);
  add_wall(scene, 2, -1, 1, -1, 1);
  scene.push_back({{{1, 0, 0}, {3, 0, 0}, {1, 0, 1}}});  // in one plane with the eye, although in front of the walls
  scene.push_back({{{1, 1, 1}, {1, 1, 1}, {1, 2, 1}}});  // not a triangle
  EXPECT_EQ(visible_triangles(kOrigin, scene, {}), (Visible{true, true, true, true, false, false}));
}

TEST(Visibility, WhatIsClippedAwayNeitherShowsNorHides) {
  const Picture near_and_far{.depth = {{1, 0, 0, -1}, {-1, 0, 0, 8}}, .sides = {}};  // 1 <= x <= 8
  for (const Viewpoint& view : {kOrigin, kAlongX}) {
    Triangles scene;
    add_wall(scene, 0.5, -9, 9, -9, 9);
    scene.push_back({{{0.5, -9, -9}, {0.5, 9, -9}, {1.5, 0, 40}}});  // reaches through the near plane, high above
    add_wall(scene, 2, -0.25, 0.25, -0.25, 0.25);
    add_wall(scene, 9, -30, 30, -30, 30);
    EXPECT_EQ(visible_triangles(view, scene, near_and_far), (Visible{false, false, true, true, true, false, false}));
    EXPECT_EQ(visible_triangles(view, scene, {}),
              (Visible{true, true, true, false, false, view.at_infinity, view.at_infinity}));
  }
}

TEST(Visibility, WhatIsBesideThePictureMayHide) {
  Triangles scene;
  add_wall(scene, 4, -2, 2, -2, 2);  // hides the other wall although a side plane beside the viewpoint cuts it
  add_wall(scene, 5, -2, 2, -2, 2);
  scene.push_back({{{4, 0, -9}, {4, 0.5, -9}, {4, 0, -8}}});
  const HalfSpaceCoefficients aslant{1, 0, 4, -4.5};  // z >= 0.125 for one, z >= -0.125 for the other
  EXPECT_EQ(visible_triangles(kAlongX, scene, {.depth = {}, .sides = {aslant}}), (Visible{true, true, false, false, false}));
  EXPECT_EQ(visible_triangles(kAlongX, scene, {.depth = {aslant}, .sides = {}}), (Visible{true, true, true, true, false}));
}

TEST(Visibility, WhatIsSeeThroughHidesNothing) {
  Triangles scene;
  for (const double x : {2, 3, 4}) add_wall(scene, x, -x, x, -x, x);
  EXPECT_EQ(visible_triangles(kOrigin, scene, {}), (Visible{true, true, false, false, false, false}));
  EXPECT_EQ(visible_triangles(kOrigin, scene, {}, {true, true, false, false, false, false}),
            (Visible{true, true, true, true, false, false}));
  EXPECT_EQ(visible_triangles(kOrigin, scene, {}, {true, true, true, true, true, true}), Visible(6, true));
  EXPECT_EQ(visible_triangles(kOrigin, scene, {}, {false, false, true, true, true, true}),
            (Visible{true, true, false, false, false, false}))
      << "it is hidden as all others are";
  EXPECT_EQ(visible_triangles(kOrigin, scene, {}, {true, false, false, false, false, false}),
            (Visible{true, true, true, false, false, false}));
}

TEST(Visibility, AtTheEndsOfTheRange) {
  for (const double scale : {0x1p-98, 0x1p96}) {
    for (const Viewpoint& view : {kOrigin, Viewpoint{{0x1p-100, 0, 0}, true}, Viewpoint{{0x1p100, 0, 0}, true}}) {
      Triangles scene;
      add_wall(scene, 4 * scale, -scale, scale, -scale, scale);
      add_wall(scene, 2 * scale, -scale, scale, -scale, scale);
      EXPECT_EQ(visible_triangles(view, scene, {}), (Visible{false, false, true, true})) << scale;
    }
  }
}

/// A point in the interior of the triangle.
Point sample(fuzz::Random& random, const Triangle& t) {
  const double a = random.real(0, 1), b = random.real(0, 1 - a), c = 1 - a - b;
  Point p{};
  for (std::size_t i = 0; i < 3; ++i) p[i] = a * t[0][i] + b * t[1][i] + c * t[2][i];
  return p;
}

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double determinant(const Point& a, const Point& b, const Point& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// 1 when the triangle crosses the segment from `eye` to `p`, -1 when it certainly does not, 0 when doubles cannot tell.
int crosses(const Triangle& t, const Point& eye, const Point& p) {
  constexpr double kSure = 1e-9;
  const Point a = minus(t[0], eye), b = minus(t[1], eye), c = minus(t[2], eye), d = minus(p, eye);
  const std::array sides{determinant(a, b, d), determinant(b, c, d), determinant(c, a, d)};
  const double whole = determinant(a, b, c), normal = sides[0] + sides[1] + sides[2];
  const auto [least, most] = std::ranges::minmax(sides);
  if (least < -kSure && most > kSure) return -1;
  if (std::fabs(whole) < kSure) return -1;  // edge-on
  if (std::fabs(normal) < kSure) return 0;
  if (whole / normal < -kSure || whole / normal > 1 + kSure) return -1;  // behind the eye, or behind p
  return std::min(std::fabs(least), std::fabs(most)) > kSure && least * most > 0 && whole / normal < 1 - kSure &&
                 whole / normal > kSure
             ? 1
             : 0;
}

TEST(Visibility, OfRandomTrianglesIsWhatSampledPointsTell) {
  fuzz::Random random(20261);
  const auto point = [&] {
    const auto next = [&] { return static_cast<double>(random.integer(-4, 4)); };
    const double x = next(), y = next(), z = next();
    return Point{x, y, z};
  };
  constexpr int kScenes = 400, kSamples = 3000;
  std::size_t visible = 0, hidden = 0, unseen = 0;
  for (int scene = 0; scene < kScenes; ++scene) {
    Triangles triangles;
    while (triangles.size() < 7) triangles.push_back({point(), point(), point()});
    const Point eye = point();
    const Visible shows = visible_triangles({eye}, triangles, {});
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      bool is_seen = false;
      for (int i = 0; i < kSamples && !is_seen; ++i) {
        const Point p = sample(random, triangles[t]);
        is_seen = crosses(triangles[t], eye, p) == 0;  // -1 if edge-on
        for (std::size_t other = 0; other < triangles.size() && is_seen; ++other) {
          is_seen = other == t || crosses(triangles[other], eye, p) == -1;
        }
      }
      EXPECT_LE(is_seen, shows[t]) << "scene " << scene << ", triangle " << t << " is seen";
      ++(shows[t] ? visible : hidden);
      unseen += shows[t] && !is_seen;
    }
  }
  EXPECT_GT(visible, 1000U);
  EXPECT_GT(hidden, 200U);
  EXPECT_LE(unseen, visible / 200) << "what shows in a small part alone can be missed by samples";
}

/// A triangle shows exactly when one of its halves does. The order of the triangles, the names of the axes and scaling by
/// powers of two do not matter.
TEST(Visibility, DoesNotDependOnHowTheSceneIsWritten) {
  fuzz::Random random(7);
  for (int scene = 0; scene < 100; ++scene) {
    const auto point = [&] {
      const double x = random.integer(-16, 16), y = random.integer(-16, 16), z = random.integer(-16, 16);
      return Point{x, y, z};
    };
    Triangles triangles;
    while (triangles.size() < 12) triangles.push_back({point(), point(), point()});
    const Viewpoint view{point(), scene % 2 == 1};
    if (view.value == Point{}) continue;
    const Picture near{.depth = {{1, 2, -1, 5}}, .sides = {{0, 1, 1, 20}}};
    const Visible shows = visible_triangles(view, triangles, near);
    Triangles halves, turned;
    for (const Triangle& t : triangles) {
      Point middle{};
      for (std::size_t i = 0; i < 3; ++i) middle[i] = (t[1][i] + t[2][i]) / 2;
      halves.insert(halves.end(), {{t[0], t[1], middle}, {t[0], t[2], middle}});
    }
    const auto turn = [](const Point& p) { return Point{-p[1] * 0x1p40, p[2] * 0x1p40, p[0] * 0x1p40}; };
    for (const Triangle& t : triangles) turned.insert(turned.begin(), {turn(t[2]), turn(t[0]), turn(t[1])});
    const Visible of_halves = visible_triangles(view, halves, near);
    const Picture near_turned{.depth = {{-2, -1, 1, 5 * 0x1p40}}, .sides = {{-1, 1, 0, 20 * 0x1p40}}};
    const Visible of_turned = visible_triangles({turn(view.value), view.at_infinity}, turned, near_turned);
    for (std::size_t t = 0; t < shows.size(); ++t) {
      EXPECT_EQ(of_halves[2 * t] || of_halves[2 * t + 1], shows[t]) << "scene " << scene << ", triangle " << t;
      EXPECT_EQ(of_turned[shows.size() - 1 - t], shows[t]) << "scene " << scene << ", triangle " << t;
    }
  }
}

}  // namespace visibility_test
