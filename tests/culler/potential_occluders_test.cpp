// SPDX-License-Identifier: MIT
#include "frusta/potential_occluders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>
#include <variant>
#include <vector>

#include "frusta/solid_angle.h"
#include "occlude/kernel/shadow_frustum.h"
#include "scenes.h"

namespace potential_occluders_test {

using namespace occlude;
using namespace occlude::culler;

constexpr double kPi = std::numbers::pi;

PolygonSoup box(bool triangles, const glm::dvec3& low, const glm::dvec3& high) {
  PolygonSoup soup;
  add_box(soup, low, high, triangles);
  return soup;
}

TEST(PotentialOccluders, ATriangleIsPartOfAFaceAndThatOfABox) {
  const PolygonSoup soup = box(true, {0, 0, 0}, {2, 3, 5});
  const PotentialOccluders occluders = PotentialOccluders::find(SharedSoup(soup), {});
  ASSERT_EQ(occluders.size(), 12U + 6U + 1U);
  constexpr std::uint32_t kShell = 18;
  for (std::uint32_t p = 0; p < 12; ++p) {
    const std::uint32_t face = occluders.container(p);
    ASSERT_GE(face, 12U);
    ASSERT_LT(face, kShell);
    EXPECT_EQ(occluders.loop(face).size(), 4U);
    EXPECT_EQ(std::ranges::count(occluders.parts(face), p), 1);
    EXPECT_EQ(occluders.container(face), kShell);
  }
  EXPECT_EQ(occluders.container(kShell), kShell);
  EXPECT_TRUE(occluders.is_shell(kShell));
  EXPECT_FALSE(occluders.is_shell(kShell - 1));
  EXPECT_EQ(occluders.parts(kShell).size(), 12U);
  EXPECT_TRUE(std::holds_alternative<kernel::Polytope>(occluders.geometry(kShell)));
  EXPECT_TRUE(std::holds_alternative<std::vector<kernel::Vec3>>(occluders.geometry(12)));
}

TEST(PotentialOccluders, WithoutShellsEveryOccluderIsFlat) {
  const PolygonSoup soup = box(true, {0, 0, 0}, {2, 3, 5});
  const PotentialOccluders occluders = PotentialOccluders::find(SharedSoup(soup), {.shells = false});
  ASSERT_EQ(occluders.size(), 18U);
  EXPECT_EQ(occluders.shells().size(), 0U);
  EXPECT_EQ(occluders.container(0), occluders.regions().whole(0));
  for (std::uint32_t i = 12; i < 18; ++i) EXPECT_EQ(occluders.container(i), i);
}

TEST(PotentialOccluders, ContainersOfQuadrilateralsAndOfPieces) {
  PolygonSoup soup = box(false, {0, 0, 0}, {2, 3, 5});
  add(soup, {{9, 0, 0}, {9, 2, 0}, {9, 2, 1}, {9, 1, 1}, {9, 1, 2}, {9, 0, 2}});  // an L
  add_wall(soup, 20, 0, 1, 0, 1);
  const PotentialOccluders occluders = PotentialOccluders::find(SharedSoup(soup), {});
  ASSERT_EQ(occluders.size(), 8U + 2U + 1U);
  for (std::uint32_t p = 0; p < 6; ++p) EXPECT_EQ(occluders.container(p), 10U) << "its shell";
  for (std::uint32_t i = 6; i < 11; ++i) EXPECT_EQ(occluders.container(i), i) << "nothing larger";
  for (const std::uint32_t piece : {8U, 9U}) EXPECT_EQ(occluders.parts(piece)[0], 6U);
}

/// The container of an occluder hides all that the occluder hides, wherever the kernel takes both.
TEST(PotentialOccluders, TheShadowOfAContainerHoldsThatOfItsParts) {
  constexpr std::uint32_t kSeed = 8;
  std::mt19937 random(kSeed);
  const PolygonSoup soup = random_town_of_houses(kSeed, 400);
  const PotentialOccluders occluders = PotentialOccluders::find(SharedSoup(soup), {});
  const auto shadow = [&](std::uint32_t i, const kernel::Vec3& eye) {
    const auto viewpoint = kernel::Viewpoint::eye(eye);
    const auto geometry = occluders.geometry(i);
    const auto* const polygon = std::get_if<std::vector<kernel::Vec3>>(&geometry);
    return polygon ? kernel::ShadowFrustum::make(viewpoint, *polygon, kernel::Near::surface)
                   : kernel::ShadowFrustum::make(viewpoint, occluders.polytope(i), kernel::Near::surface);
  };
  std::size_t asked = 0, in_parts = 0;
  for (std::uint32_t i = 0; i < occluders.size(); ++i) {
    const std::uint32_t container = occluders.container(i);
    if (container == i) continue;
    for (int n = 0; n < 5; ++n) {
      const glm::dvec3 eye{uniform(random, -60, 60), uniform(random, -60, 60), uniform(random, 0, 12)};
      const kernel::Vec3 from{eye.x, eye.y, eye.z};
      const auto part = shadow(i, from).frustum, whole = shadow(container, from).frustum;
      if (!part || !whole) continue;
      for (int k = 0; k < 20; ++k) {
        const glm::dvec3 v = eye + uniform(random, 1, 4) * (occluders[i].centre - eye) + random_point(random);
        const kernel::Aabb point{{v.x, v.y, v.z}, {v.x, v.y, v.z}};
        ++asked;
        if (kernel::overlap_certified(*part, point, kernel::NearBoundary::open).relation != kernel::Relation::inside)
          continue;
        ++in_parts;
        ASSERT_EQ(kernel::overlap_certified(*whole, point, kernel::NearBoundary::open).relation, kernel::Relation::inside)
            << "seed " << kSeed << ", occluder " << i;
      }
    }
  }
  EXPECT_GT(in_parts, asked / 10);
}

TEST(AreaAngle, OfAShellIsAQuarterOfItsSurfaceOverTheSquaredDistance) {
  const PolygonSoup soup = box(true, {-1, -1, -1}, {1, 1, 1});
  const PotentialOccluders occluders = PotentialOccluders::find(SharedSoup(soup), {});
  const PotentialOccluder& shell = occluders[occluders.size() - 1];
  EXPECT_DOUBLE_EQ(shell.round_area, 6);
  EXPECT_DOUBLE_EQ(shell.radius, std::sqrt(3));
  EXPECT_NEAR(glm::length(shell.centre), 0, 1e-15);
  for (const glm::dvec3& eye : {glm::dvec3{10, 0, 0}, glm::dvec3{0, -6, 8}}) EXPECT_DOUBLE_EQ(shell.area_angle(eye), 0.06);
  EXPECT_EQ(shell.area_angle(shell.centre), 0);
  EXPECT_DOUBLE_EQ(shell.area(), 6);
}

/// Far from a shell, its area-angle is the mean of its solid angle over all directions. The solid angle of a cube differs
/// from that by less than 40 % in any direction.
TEST(AreaAngle, OfARoundShellIsAboutItsSolidAngle) {
  const PolygonSoup soup = box(false, {-1, -1, -1}, {1, 1, 1});
  const PotentialOccluders occluders = PotentialOccluders::find(SharedSoup(soup), {});
  const auto shell = static_cast<std::uint32_t>(occluders.size() - 1);
  Camera camera;
  std::mt19937 random(1);
  double mean = 0;
  for (int i = 0; i < 1000; ++i) {
    glm::dvec3 way;
    do way = random_point(random);
    while (glm::length(way) > 1 || glm::length(way) < 0.1);
    camera.eye = 20.0 * glm::normalize(way);
    const double exact = seen_size(occluders, shell, FrameView(camera, 0), Objective::Angle::exact);
    const double area = seen_size(occluders, shell, FrameView(camera, 0), Objective::Angle::area);
    EXPECT_GT(exact, 0.6 * area);
    EXPECT_LT(exact, 1.4 * area);
    mean += exact / area / 1000;
  }
  EXPECT_NEAR(mean, 1, 0.02) << "Cauchy: the mean of a convex body's projections is a quarter of its surface";
}

TEST(SolidAngle, OfTriangles) {
  const glm::dvec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  EXPECT_DOUBLE_EQ(solid_angle(x, y, z), kPi / 2) << "an octant";
  EXPECT_DOUBLE_EQ(solid_angle(3.0 * x, 0.5 * y, 7.0 * z), kPi / 2) << "how far the corners are does not count";
  EXPECT_DOUBLE_EQ(solid_angle(y, x, z), -kPi / 2);
  EXPECT_EQ(solid_angle(x, x, z), 0);
  EXPECT_DOUBLE_EQ(std::fabs(solid_angle(x, y, -x - y)), 2 * kPi) << "the eye in the triangle: half of all directions";
  // The regular tetrahedron around the eye.
  const glm::dvec3 a{1, 1, 1}, b{1, -1, -1}, c{-1, 1, -1};
  EXPECT_DOUBLE_EQ(std::fabs(solid_angle(a, b, c)), kPi);
  EXPECT_DOUBLE_EQ(std::fabs(solid_angle(2.0 * a, 3.0 * b, 7.0 * c)), kPi);
}

TEST(SeenSize, OfPolygonsAndShells) {
  PolygonSoup soup = box(true, {1, -1, -1}, {3, 1, 1});
  const PotentialOccluders occluders = PotentialOccluders::find(SharedSoup(soup), {});
  const auto shell = static_cast<std::uint32_t>(occluders.size() - 1);
  Camera camera;
  const auto size = [&](std::uint32_t i) { return seen_size(occluders, i, FrameView(camera, 0), Objective::Angle::exact); };
  EXPECT_NEAR(size(shell), 2 * kPi / 3, 1e-14) << "from here a sixth of all directions";
  EXPECT_NEAR(size(occluders.container(0)), 2 * kPi / 3, 1e-14) << "the side towards the eye";
  EXPECT_NEAR(size(0), kPi / 3, 1e-14);
  // With parallel rays, the share of the picture.
  camera.projection = Projection::orthographic;
  camera.height = 10;
  camera.aspect = 2;
  EXPECT_DOUBLE_EQ(size(occluders.container(0)), 4 / 200.0);
  EXPECT_DOUBLE_EQ(size(shell), 6 / 200.0) << "a quarter of the surface";
}

}  // namespace potential_occluders_test
