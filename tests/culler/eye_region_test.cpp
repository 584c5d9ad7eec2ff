// SPDX-License-Identifier: MIT
// Culls that hold for a region of eyes: nothing that any of them sees is culled.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <iostream>
#include <random>
#include <vector>

#include "frames.h"
#include "occlude/culler/camera.h"
#include "occlude/culler/culler.h"
#include "sanitized.h"
#include "scenes.h"
#include "seed.h"
#include "seen_by_rays.h"

namespace occlude::culler {
namespace eye_region_test {

using glm::dvec3;

std::uint32_t some_seed(std::mt19937& random) { return static_cast<std::uint32_t>(random()); }

/// A ball, a box, a rectangle, or the way ahead.
EyeRegion some_region(std::mt19937& random, const Camera& camera) {
  const double size = std::exp(uniform(random, std::log(0.01), std::log(3)));
  switch (random() % 4) {
    case 0:
      return EyeRegion::ball(size);
    case 1:
      return EyeRegion::box(size * random_point(random), 0.5 * size * random_point(random),
                            0.3 * size * random_point(random));
    case 2:
      return EyeRegion::box(size * random_point(random), size * random_point(random));
    default:
      return EyeRegion::box(size * camera.axes().forward, 0.05 * camera.axes().right);
  }
}

/// An eye of the region: at a corner or on the sphere, on an edge, or anywhere.
dvec3 some_eye(std::mt19937& random, const EyeRegion& eyes) {
  if (eyes.radius > 0) {
    const dvec3 direction = glm::normalize(random_point(random));
    return direction * eyes.radius * (random() % 2 == 0 ? 1 - 1e-9 : uniform(random, 0, 1));
  }
  dvec3 eye(0);
  for (const dvec3& half_edge : eyes.half_edges) {
    eye += half_edge * (random() % 4 != 0 ? (random() % 2 == 0 ? 1.0 : -1.0) : uniform(random, -1, 1));
  }
  return eye;
}

class EyeRegionTest : public testing::TestWithParam<Method> {};

INSTANTIATE_TEST_SUITE_P(Culler, EyeRegionTest, testing::Values(Method::frusta, Method::cover),
                         [](const auto& tested) { return tested.param == Method::frusta ? "Frusta" : "Cover"; });

TEST_P(EyeRegionTest, NothingThatAnyEyeSeesIsCulled) {
  const std::uint32_t seed = seed_of(11);
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  std::size_t hidden = 0, rays = 0, seen = 0;
  for (int i = 0; i < unless_sanitized(600, 100); ++i) {
    const PolygonSoup soup =
        i % 2 == 0 ? random_town(some_seed(random), 300) : random_town_of_houses(some_seed(random), 300);
    Camera camera = random_camera(random);
    camera.projection = Projection::perspective;
    camera.near_plane = std::array{0.01, 0.1, 1.0, 4.0}[random() % 4];
    camera.eyes = some_region(random, camera);
    ASSERT_EQ(fault(camera), "");
    const Culler culler = small_leaves(soup);
    CullOptions options{.method = Method::frusta};
    options.method = GetParam();
    const CullResult frame = culler.cull(camera, options);
    const SoupView all = culler.hierarchy().soup();
    const std::vector<bool> drawn = drawn_polygons(culler, frame);
    hidden += frame.stats.shadow_culled_polygons;
    Picture picture(camera);
    for (std::uint32_t p = 0; p < drawn.size(); ++p) {
      for (int k = 0; k < 8; ++k) {
        picture.eye = Vector(camera.eye + some_eye(random, camera.eyes));
        const dvec3 point = some_point(all, p, random);
        if (!picture.shows(point)) continue;
        ++rays;
        if (!is_clear(all, picture, point, p)) continue;
        ++seen;
        ASSERT_TRUE(drawn[p]) << "frame " << i << ", polygon " << p << ", eye " << k;
      }
    }
  }
  std::cout << hidden << " polygons hidden, " << rays << " rays, " << seen << " of them clear\n";
  EXPECT_GT(hidden, unless_sanitized(6U, 1U) * (GetParam() == Method::cover ? 1600 : 400));
  EXPECT_GT(seen, unless_sanitized(6U, 1U) * 16000);
}

/// As a region shrinks to a point, it culls what the point culls.
TEST(EyeRegion, OfNoExtentCullsAsItsPoint) {
  std::mt19937 random(seed_of(5));
  std::size_t of_points = 0, of_regions = 0;
  for (int i = 0; i < 40; ++i) {
    const Culler culler = small_leaves(random_town_of_houses(some_seed(random), 400));
    Camera camera = random_camera(random);
    camera.projection = Projection::perspective;
    CullOptions options{.method = Method::frusta};
    options.method = Method::cover;
    of_points += culler.cull(camera, options).stats.shadow_culled_polygons;
    camera.eyes = i % 2 == 0 ? EyeRegion::ball(1e-9) : EyeRegion::box({1e-9, 0, 0}, {0, 1e-9, 0});
    of_regions += culler.cull(camera, options).stats.shadow_culled_polygons;
  }
  EXPECT_GT(of_regions, 0.99 * static_cast<double>(of_points));
}

/// A larger region draws more: more is in view, and less is hidden.
TEST(EyeRegion, LargerOnesDrawMore) {
  const Culler culler = small_leaves(random_town_of_houses(3, 2000));
  CullOptions options{.method = Method::frusta};
  options.method = Method::cover;
  std::mt19937 random(seed_of(7));
  std::array<std::size_t, 4> drawn{};
  for (int i = 0; i < 30; ++i) {
    Camera camera = random_camera(random);
    camera.projection = Projection::perspective;
    for (std::size_t k = 0; k < drawn.size(); ++k) {
      camera.eyes = EyeRegion::ball(std::array{0.01, 0.1, 0.5, 2.0}[k]);
      drawn[k] += culler.cull(camera, options).stats.drawn_polygons;
    }
  }
  EXPECT_TRUE(std::ranges::is_sorted(drawn));
}

/// Of a small ball, not even the square of the radius is a float.
TEST(EyeRegion, CullsTheSameOfAnySize) {
  std::mt19937 random(seed_of(9));
  CullOptions options{.method = Method::frusta};
  options.method = Method::cover;
  std::size_t hidden = 0;
  for (int i = 0; i < 20; ++i) {
    const PolygonSoup soup = random_town_of_houses(some_seed(random), 300);
    Camera camera = random_camera(random);
    camera.projection = Projection::perspective;
    camera.near_plane = 0.1;
    camera.eyes = i % 2 == 0 ? EyeRegion::ball(0.125) : EyeRegion::box({0.125, 0, 0}, {0, 0.25, 0});
    const Culler culler = small_leaves(soup);
    const CullResult frame = culler.cull(camera, options);
    hidden += frame.stats.shadow_culled_polygons;
    for (const double size : {0x1p-76, 0x1p-60, 0x1p60, 0x1p76}) {
      PolygonSoup other = soup;
      for (dvec3& v : other.vertices) v *= size;
      Camera of_other = camera;
      for (dvec3* v : {&of_other.eye, &of_other.target}) *v *= size;
      of_other.near_plane *= size;
      of_other.far_plane *= size;
      of_other.eyes.radius *= size;
      for (dvec3& half_edge : of_other.eyes.half_edges) half_edge *= size;
      const CullResult result = small_leaves(other).cull(of_other, options);
      EXPECT_EQ(result.drawn, frame.drawn) << "frame " << i << ", size " << size;
    }
  }
  EXPECT_GT(hidden, 500U);
}

TEST(EyeRegion, ReachesAsFarAsItsFarthestEye) {
  EXPECT_EQ(EyeRegion{}.reach({1, 2, 3}), 0);
  EXPECT_EQ(EyeRegion::ball(2).reach({0, 3, 4}), 10);
  EXPECT_EQ(EyeRegion::box({1, 0, 0}, {0, -2, 0}, {1, 1, 1}).reach({1, 0, 0}), 2);
  EXPECT_EQ(EyeRegion::box({1, 0, 0}, {0, -2, 0}, {1, 1, 1}).reach({0, 1, 0}), 3);
  EXPECT_TRUE(EyeRegion::box({0, 0, 0}).is_point());
}

}  // namespace eye_region_test
}  // namespace occlude::culler
