// SPDX-License-Identifier: MIT
// Culls that hold for a region of eyes: nothing that any of them sees is culled.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>
#include <iostream>
#include <random>
#include <vector>

#include "frames.h"
#include "occlude/culler/camera.h"
#include "occlude/culler/culler.h"
#include "scenes.h"

namespace occlude::culler {
namespace eye_region_test {

using glm::dvec3;

/// The seed of a test; OCCLUDE_SEED takes another one.
std::uint32_t seed_of(std::uint32_t usual) {
  const char* const given = std::getenv("OCCLUDE_SEED");
  return given != nullptr ? static_cast<std::uint32_t>(std::strtoul(given, nullptr, 10)) : usual;
}

std::uint32_t some_seed(std::mt19937& random) { return static_cast<std::uint32_t>(random()); }

Culler culler_of(const PolygonSoup& soup) { return Culler(soup, {.hierarchy = {.leaf_size = 2}, .lists = {.regions = 8}}); }

/// What a ray from an eye meets, by brute force. Whatever is within rounding counts as met.
class Rays {
 public:
  explicit Rays(SoupView soup) {
    for (std::size_t p = 0; p < soup.size(); ++p) {
      const auto loop = soup.loop(p);
      for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        triangles_.push_back({soup.vertices[loop[0]], soup.vertices[loop[i]], soup.vertices[loop[i + 1]]});
      }
    }
  }

  /// Whether nothing is between the eye and the point, from the share `from` of the way on.
  [[nodiscard]] bool are_clear(const dvec3& eye, const dvec3& point, double from) const {
    const dvec3 way = point - eye;
    return std::ranges::none_of(triangles_, [&](const std::array<dvec3, 3>& t) {
      const dvec3 a = t[1] - t[0], b = t[2] - t[0], n = glm::cross(a, b);
      const double along = glm::dot(n, way);
      if (std::fabs(along) < 1e-12 * glm::length(n) * glm::length(way)) return false;
      const double at = glm::dot(n, t[0] - eye) / along;
      if (at < from || at > 1 - 1e-9) return false;
      const dvec3 met = eye + at * way - t[0];
      const double square = glm::dot(n, n);
      const double u = glm::dot(glm::cross(met, b), n) / square, v = glm::dot(glm::cross(a, met), n) / square;
      return u > -kRounded && v > -kRounded && u + v < 1 + kRounded;
    });
  }

 private:
  static constexpr double kRounded = 1e-9;
  std::vector<std::array<dvec3, 3>> triangles_;
};

dvec3 some_vector(std::mt19937& random) { return {uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)}; }

/// A ball, a box, a rectangle, or the way ahead.
EyeRegion some_region(std::mt19937& random, const Camera& camera) {
  const double size = std::exp(uniform(random, std::log(0.01), std::log(3)));
  switch (random() % 4) {
    case 0:
      return EyeRegion::ball(size);
    case 1:
      return EyeRegion::box(size * some_vector(random), 0.5 * size * some_vector(random), 0.3 * size * some_vector(random));
    case 2:
      return EyeRegion::box(size * some_vector(random), size * some_vector(random));
    default:
      return EyeRegion::box(size * camera.axes().forward, 0.05 * camera.axes().right);
  }
}

/// An eye of the region: at a corner or on the sphere, on an edge, or anywhere.
dvec3 some_eye(std::mt19937& random, const EyeRegion& eyes) {
  if (eyes.radius > 0) {
    const dvec3 direction = glm::normalize(some_vector(random));
    return direction * eyes.radius * (random() % 2 == 0 ? 1 - 1e-9 : uniform(random, 0, 1));
  }
  dvec3 eye(0);
  for (const dvec3& half_edge : eyes.half_edges) {
    eye += half_edge * (random() % 4 != 0 ? (random() % 2 == 0 ? 1.0 : -1.0) : uniform(random, -1, 1));
  }
  return eye;
}

/// Whether the camera at another eye has the point in its picture, beyond its near plane.
bool shows(const Camera& camera, const dvec3& eye, const dvec3& point) {
  const auto [right, up, forward] = camera.axes();
  const dvec3 way = point - eye;
  const double ahead = glm::dot(way, forward), half = std::tan(glm::radians(camera.fov_y_deg) / 2);
  return ahead > camera.near_plane && ahead < camera.far_plane && std::fabs(glm::dot(way, up)) < half * ahead &&
         std::fabs(glm::dot(way, right)) < half * camera.aspect * ahead;
}

class EyeRegionTest : public testing::TestWithParam<Method> {};

INSTANTIATE_TEST_SUITE_P(Culler, EyeRegionTest, testing::Values(Method::frusta, Method::cover),
                         [](const auto& tested) { return tested.param == Method::frusta ? "Frusta" : "Cover"; });

TEST_P(EyeRegionTest, NothingThatAnyEyeSeesIsCulled) {
  const std::uint32_t seed = seed_of(11);
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  std::size_t hidden = 0, rays = 0, seen = 0;
  for (int i = 0; i < 1200; ++i) {
    const PolygonSoup soup =
        i % 2 == 0 ? random_town(some_seed(random), 300) : random_town_of_houses(some_seed(random), 300);
    Camera camera = random_camera(random);
    camera.projection = Projection::perspective;
    camera.near_plane = std::array{0.01, 0.1, 1.0, 4.0}[random() % 4];
    camera.eyes = some_region(random, camera);
    ASSERT_EQ(fault(camera), "");
    const Culler culler = culler_of(soup);
    CullOptions options;
    options.method = GetParam();
    const CullResult frame = culler.cull(camera, options);
    const Rays all(culler.hierarchy().soup());
    const std::vector<bool> drawn = drawn_polygons(culler, frame);
    hidden += frame.stats.shadow_culled_polygons;
    for (std::uint32_t p = 0; p < drawn.size(); ++p) {
      const auto loop = culler.hierarchy().soup().loop(p);
      for (int k = 0; k < 8; ++k) {
        const dvec3 eye = camera.eye + some_eye(random, camera.eyes);
        const double share = uniform(random, 0, 1);
        const auto vertex = [&](std::size_t v) { return culler.hierarchy().soup().vertices[loop[v]]; };
        const std::size_t v = random() % (loop.size() - 2);
        const dvec3 point = glm::mix(vertex(0), glm::mix(vertex(v + 1), vertex(v + 2), uniform(random, 0, 1)), share);
        if (!shows(camera, eye, point)) continue;
        const double ahead = glm::dot(point - eye, camera.axes().forward);
        ++rays;
        if (!all.are_clear(eye, point, camera.near_plane / ahead * (1 - 1e-9))) continue;
        ++seen;
        ASSERT_TRUE(drawn[p]) << "frame " << i << ", polygon " << p << ", eye " << k;
      }
    }
  }
  std::cout << hidden << " polygons hidden, " << rays << " rays, " << seen << " of them clear\n";
  EXPECT_GT(hidden, GetParam() == Method::cover ? 20000U : 5000U);
  EXPECT_GT(seen, 200000U);
}

/// As a region shrinks to a point, it culls what the point culls.
TEST(EyeRegion, OfNoExtentCullsAsItsPoint) {
  std::mt19937 random(seed_of(5));
  std::size_t of_points = 0, of_regions = 0;
  for (int i = 0; i < 40; ++i) {
    const Culler culler = culler_of(random_town_of_houses(some_seed(random), 400));
    Camera camera = random_camera(random);
    camera.projection = Projection::perspective;
    CullOptions options;
    options.method = Method::cover;
    of_points += culler.cull(camera, options).stats.shadow_culled_polygons;
    camera.eyes = i % 2 == 0 ? EyeRegion::ball(1e-9) : EyeRegion::box({1e-9, 0, 0}, {0, 1e-9, 0});
    of_regions += culler.cull(camera, options).stats.shadow_culled_polygons;
  }
  EXPECT_GT(of_regions, 0.99 * static_cast<double>(of_points));
}

/// A larger region draws more: more is in view, and less is hidden.
TEST(EyeRegion, LargerOnesDrawMore) {
  const Culler culler = culler_of(random_town_of_houses(3, 2000));
  CullOptions options;
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

TEST(EyeRegion, ReachesAsFarAsItsFarthestEye) {
  EXPECT_EQ(EyeRegion{}.reach({1, 2, 3}), 0);
  EXPECT_EQ(EyeRegion::ball(2).reach({0, 3, 4}), 10);
  EXPECT_EQ(EyeRegion::box({1, 0, 0}, {0, -2, 0}, {1, 1, 1}).reach({1, 0, 0}), 2);
  EXPECT_EQ(EyeRegion::box({1, 0, 0}, {0, -2, 0}, {1, 1, 1}).reach({0, 1, 0}), 3);
  EXPECT_TRUE(EyeRegion::box({0, 0, 0}).is_point());
}

}  // namespace eye_region_test
}  // namespace occlude::culler
