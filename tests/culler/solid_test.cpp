// SPDX-License-Identifier: MIT
// Triangles and boxes that touch, and rays through edges and corners.
#include "frusta/solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "model/bounds.h"
#include "scenes.h"

namespace solid_test {

using namespace occlude::culler;
using occlude::kernel::Aabb;
using occlude::kernel::Vec3;

constexpr Aabb kBox{{0, 0, 0}, {2, 2, 2}};

bool meets(const Vec3& a, const Vec3& b, const Vec3& c, const Aabb& box = kBox) {
  SolidTriangle triangle{{a, b, c}, empty_box()};
  for (const Vec3& point : triangle.corners) grow(triangle.box, point);
  return meets_interior(triangle, box);
}

Solid solid_of(SoupView soup) {
  std::vector<std::uint32_t> all(soup.size());
  std::iota(all.begin(), all.end(), 0U);
  return {soup, all};
}

double above(double x) { return std::nextafter(x, 1e300); }
double below(double x) { return std::nextafter(x, -1e300); }

TEST(MeetsInterior, NotWhatTouchesAFace) {
  EXPECT_FALSE(meets({2, 0, 0}, {2, 2, 0}, {2, 0, 2}));
  EXPECT_TRUE(meets({below(2), 0, 0}, {2, 2, 0}, {2, 0, 2}));
  EXPECT_FALSE(meets({2, 1, 1}, {9, 1, 1}, {9, 2, 2}));
  EXPECT_TRUE(meets({below(2), 1, 1}, {9, 1, 1}, {9, 2, 2}));
  EXPECT_TRUE(meets({-9, -9, 1}, {9, -9, 1}, {0, 30, 1})) << "the box within the triangle's outline";
  EXPECT_TRUE(meets({1, 1, 1}, {1.5, 1, 1}, {1, 1.5, 1})) << "the triangle within the box";
}

/// Only the triangle's own plane tells them apart.
TEST(MeetsInterior, NotWhatTouchesACornerWithItsPlane) {
  EXPECT_FALSE(meets({6, 0, 0}, {0, 6, 0}, {0, 0, 6}));
  EXPECT_TRUE(meets({below(6), 0, 0}, {0, 6, 0}, {0, 0, 6}));
  EXPECT_FALSE(meets({6, 0, 0}, {0, 0, 6}, {0, 6, 0})) << "turned";
}

/// Only a plane through edges of both does: a side of the triangle crosses an edge of the box.
TEST(MeetsInterior, NotWhatTouchesAnEdgeWithASide) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double mirror : {1.0, -1.0}) {
      // A side from (4, 0) to (0, 4) over the edge (2, 2), along the axis from 0 to 2; the third corner farther out.
      const auto turned = [&](double i, double j, double along) {
        Vec3 point;
        point[axis] = along;
        point[(axis + 1) % 3] = 1 + (i - 1) * mirror;
        point[(axis + 2) % 3] = j;
        return point;
      };
      const Vec3 third = turned(5, 4.5, 1);
      EXPECT_FALSE(meets(turned(4, 0, 0.5), turned(0, 4, 1.5), third)) << axis << mirror;
      EXPECT_TRUE(meets(turned(4, 0, 0.5), turned(0, below(4), 1.5), third)) << axis << mirror;
      EXPECT_TRUE(meets(turned(4, 0, 0.5), turned(0, 4, 1.5), turned(0, 0, 1))) << "a third corner in it";
      EXPECT_TRUE(meets(turned(4, 0, 0.5), turned(0, 4, 1.5), turned(-3, -3, 1))) << "and beyond it";
    }
  }
}

TEST(MeetsInterior, TrianglesWithoutArea) {
  EXPECT_TRUE(meets({-1, -1, -1}, {1, 1, 1}, {3, 3, 3}));
  EXPECT_TRUE(meets({-1, 1, 1}, {3, 1, 1}, {-1, 1, 1})) << "along an axis";
  EXPECT_FALSE(meets({-1, 2, 1}, {3, 2, 1}, {-1, 2, 1}));
  EXPECT_FALSE(meets({4, 0, 0}, {0, 4, 2}, {2, 2, 1})) << "a segment that touches an edge";
  EXPECT_TRUE(meets({below(4), 0, 0}, {0, 4, 2}, {0, 4, 2}));
  EXPECT_TRUE(meets({1, 1, 1}, {1, 1, 1}, {1, 1, 1}));
  EXPECT_FALSE(meets({2, 1, 1}, {2, 1, 1}, {2, 1, 1}));
}

TEST(MeetsInterior, FarAndTiny) {
  const double far = 0x1p40, ulp = 0x1p-12;
  const Aabb box{{far, far, far}, {far + 2 * ulp, far + 2 * ulp, far + 2 * ulp}};
  const auto at = [&](double x, double y, double z) { return Vec3{far + x * ulp, far + y * ulp, far + z * ulp}; };
  EXPECT_FALSE(meets(at(6, 0, 0), at(0, 6, 0), at(0, 0, 6), box));
  EXPECT_TRUE(meets(at(5, 0, 0), at(0, 6, 0), at(0, 0, 6), box));
  const double tiny = 0x1p-99;
  EXPECT_FALSE(meets({3 * tiny, 0, 0}, {0, 3 * tiny, 0}, {0, 0, 3 * tiny}, {{0, 0, 0}, {tiny, tiny, tiny}}));
  EXPECT_TRUE(meets({below(3 * tiny), 0, 0}, {0, 3 * tiny, 0}, {0, 0, 3 * tiny}, {{0, 0, 0}, {tiny, tiny, tiny}}));
}

/// Rays from points of a lattice run through corners, along edges and in faces.
TEST(IsInside, OfAnOctahedronFromEveryPointOfALattice) {
  PolygonSoup soup;
  for (const double x : {-4.0, 4.0}) {
    for (const double y : {-4.0, 4.0}) {
      for (const double z : {-4.0, 4.0}) add(soup, {{x, 0, 0}, {0, y, 0}, {0, 0, z}});
    }
  }
  const Solid solid = solid_of(soup);
  for (int x = -5; x <= 5; ++x) {
    for (int y = -5; y <= 5; ++y) {
      for (int z = -5; z <= 5; ++z) {
        const int distance = std::abs(x) + std::abs(y) + std::abs(z);
        if (distance == 4) continue;
        const Vec3 point{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
        EXPECT_EQ(is_inside(solid, point), distance < 4) << x << ' ' << y << ' ' << z;
      }
    }
  }
}

TEST(IsInside, OfABoxWithDiagonalsOfEveryKind) {
  for (const bool triangles : {false, true}) {
    PolygonSoup soup;
    add_box(soup, {-2, -2, -2}, {2, 2, 2}, triangles);
    const Solid solid = solid_of(soup);
    for (int i = 0; i < 7 * 7 * 7; ++i) {
      const Vec3 point{i % 7 - 3.0, i / 7 % 7 - 3.0, i / 49 - 3.0};
      const double reach = std::max({std::fabs(point.x), std::fabs(point.y), std::fabs(point.z)});
      if (reach == 2) continue;
      EXPECT_EQ(is_inside(solid, point), reach < 2) << i;
    }
  }
}

TEST(IsInside, CountsShellsModuloTwo) {
  PolygonSoup soup;
  soup.add_box({0, 0, 0}, {8, 8, 8});
  soup.add_box({2, 2, 2}, {6, 6, 6});
  const Solid solid = solid_of(soup);
  EXPECT_TRUE(is_inside(solid, {1, 4, 4}));
  EXPECT_FALSE(is_inside(solid, {4, 4, 4}));
  EXPECT_TRUE(is_inside(solid, {7, 4, 4}));
  EXPECT_FALSE(is_inside(solid, {above(8), 4, 4}));
}

}  // namespace solid_test
