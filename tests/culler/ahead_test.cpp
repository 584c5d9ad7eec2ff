// SPDX-License-Identifier: MIT
// Cameras whose frames hold for the way ahead.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <random>

#include "camera/frame_view.h"
#include "camera/holds_for.h"
#include "frames.h"
#include "occlude/culler/camera.h"
#include "sanitized.h"
#include "scenes.h"
#include "seed.h"

namespace ahead_test {

using namespace occlude::culler;
using glm::dvec3;
using occlude::seed_of;
using occlude::unless_sanitized;

constexpr unsigned kCameras = unless_sanitized(5000U, 200U);

dvec3 some_direction(std::mt19937& random) {
  for (;;) {
    const dvec3 v = random_point(random);
    if (const double length = glm::length(v); length > 0.1 && length < 1) return v / length;
  }
}

dvec3 turned(const dvec3& v, const dvec3& axis, double angle) {
  return std::cos(angle) * v + std::sin(angle) * glm::cross(axis, v) + (1 - std::cos(angle)) * glm::dot(axis, v) * axis;
}

Camera some_camera(std::mt19937& random) {
  Camera camera = random_camera(random);
  camera.projection = Projection::perspective;
  camera.fov_y_deg = uniform(random, 20, 100);
  camera.aspect = uniform(random, 0.5, 2);
  camera.near_plane = uniform(random, 0.05, 0.5);
  if (random() % 4 == 0) camera.eyes = EyeRegion::ball(uniform(random, 0.01, 0.1));
  return camera;
}

/// The camera farther on its way, beside it and turned.
Camera later(std::mt19937& random, Camera camera, const dvec3& way, const AheadOptions& options, double turn) {
  const dvec3 sight = camera.target - camera.eye, axis = some_direction(random);
  const double length = glm::length(way);
  dvec3 beside = random() % 2 == 0 ? dvec3(0) : 0.99 * options.up * some_direction(random);
  if (length > 0) beside -= glm::dot(beside, way) / (length * length) * way;
  const double share = random() % 4 == 0 ? static_cast<double>(random() % 2) : uniform(random, 0, 1);
  camera.eye += share * way + beside;
  camera.target = camera.eye + turned(sight, axis, glm::radians(turn));
  camera.up = turned(camera.up, axis, glm::radians(turn));
  return camera;
}

TEST(Ahead, HoldsOnTheWay) {
  std::mt19937 random(seed_of(5611));
  unsigned beyond = 0;
  for (unsigned k = 0; k < kCameras; ++k) {
    const Camera camera = some_camera(random);
    const AheadOptions options{.aside = uniform(random, 0.05, 0.2),
                               .up = uniform(random, 0.02, 0.05),
                               .turn_degrees = random() % 2 == 0 ? 0 : uniform(random, 0, 20)};
    const dvec3 velocity = random() % 8 == 0 ? dvec3(0) : uniform(random, 0, 20) * some_direction(random);
    const double seconds = uniform(random, 0, 1);
    const FrameView view(ahead(camera, velocity, seconds, options), 200);
    const FrameView of_matrix(ahead(matrix_of(camera), velocity, seconds, options), 200);
    for (int other = 0; other < 10; ++other) {
      const double turn = options.turn_degrees == 0 ? 0 : options.turn_degrees * uniform(random, 0, 1);
      const Camera there = later(random, camera, seconds * velocity, options, turn);
      ASSERT_TRUE(holds_for(view, there)) << "camera " << k;
      ASSERT_TRUE(holds_for(of_matrix, matrix_of(there))) << "camera " << k;
    }
    if (options.turn_degrees == 0) continue;
    beyond += holds_for(view, later(random, camera, seconds * velocity, options, 1.5 * options.turn_degrees)) ? 0 : 1;
  }
  EXPECT_GT(beyond, kCameras / 20);
}

TEST(Ahead, IsNoWiderThanItMustBe) {
  const Camera camera{.eye = {0, 0, 2}, .target = {1, 0, 2}, .fov_y_deg = 60, .aspect = 16.0 / 9};
  const Camera wide = ahead(camera, {1.5, 0, 0}, 2, {.turn_degrees = 10});
  const double tangent = std::tan(glm::radians(30.0)), of_wide = std::tan(glm::radians(wide.fov_y_deg) / 2);
  EXPECT_NEAR(of_wide / tangent, 1.64, 0.005);
  EXPECT_NEAR(of_wide * wide.aspect / (tangent * camera.aspect), 1.474, 0.005);
  EXPECT_NEAR(wide.near_plane / camera.near_plane, 1.19 * (1 + 1.0 / 64), 0.01);
  EXPECT_EQ(wide.far_plane, camera.far_plane);
  EXPECT_NEAR(glm::length(wide.eyes.half_edges[0]), 1.5, 1e-9);
  EXPECT_NEAR(glm::length(wide.eyes.half_edges[1]), 0.1, 1e-9);
  EXPECT_NEAR(glm::length(wide.eyes.half_edges[2]), 0.05, 1e-9);
  EXPECT_NEAR(glm::length(wide.eye - dvec3(1.5, 0, 2)), 0, 1e-9);
}

TEST(Ahead, PicturesThatCannotBeWider) {
  const Camera camera{.eye = {0, 0, 2}, .target = {1, 0, 2}, .fov_y_deg = 170};
  for (const double turn : {5.0, 50.0, 120.0, 1e6}) {
    const Camera wide = ahead(camera, {1, 0, 0}, 1, {.turn_degrees = turn});
    EXPECT_EQ(fault(wide), "");
    EXPECT_TRUE(holds_for(FrameView(wide, 100), camera)) << turn;
  }
}

TEST(Ahead, HoldsNowhereElse) {
  const Camera camera{.eye = {0, 0, 2}, .target = {1, 0, 2}};
  const FrameView view(ahead(camera, {1, 0, 0}, 2), 100);
  const auto holds_at = [&](const dvec3& moved) {
    Camera there = camera;
    there.eye += moved;
    there.target += moved;
    return holds_for(view, there);
  };
  EXPECT_TRUE(holds_at({0, 0, 0}) && holds_at({2, 0, 0}) && holds_at({1, 0.099, -0.049}));
  EXPECT_FALSE(holds_at({-0.001, 0, 0}) || holds_at({2.001, 0, 0}) || holds_at({1, 0.101, 0}) || holds_at({1, 0, 0.051}));
}

/// A mirror's near plane does not cross the rays that look down.
TEST(Ahead, AnObliqueNearPlaneHidesNothing) {
  MatrixCamera camera = matrix_of(Camera{.eye = {0, 0, 2}, .target = {1, 0, 2}});
  for (int k = 0; k < 4; ++k) camera.matrix[k][2] = k == 2 ? 1e-3 : k == 3 ? -3e-3 : 0;  // z >= 3
  ASSERT_EQ(fault(camera), "");
  EXPECT_GT(ahead(camera, {1, 0, 0}, 1).near_plane, 1e20);
}

TEST(Ahead, Refuses) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  EXPECT_NE(refusal([] { static_cast<void>(ahead(Camera{.near_plane = -1}, {1, 0, 0}, 1)); }), "");
  for (const double number : {nan, infinity, 1e300}) {
    EXPECT_NE(refusal([&] { static_cast<void>(ahead(Camera{}, {number, 0, 0}, 1)); }), "") << number;
    EXPECT_NE(refusal([&] { static_cast<void>(ahead(Camera{}, {1, 0, 0}, number)); }), "") << number;
    EXPECT_NE(refusal([&] { static_cast<void>(ahead(Camera{}, {1, 0, 0}, 1, {.aside = number})); }), "") << number;
  }
  EXPECT_NE(refusal([&] { static_cast<void>(ahead(Camera{}, {1, 0, 0}, 1, {.turn_degrees = nan})); }), "");
  EXPECT_NE(refusal([&] { static_cast<void>(ahead(Camera{}, {1, 0, 0}, 1, {.turn_degrees = -1})); }), "");
  const Camera parallel{.projection = Projection::orthographic};
  EXPECT_NE(refusal([&] { static_cast<void>(ahead(matrix_of(parallel), {1, 0, 0}, 1)); }), "");
}

/// Numbers that are out of the kernel's range count as 0.
TEST(Ahead, HalfEdgesThatAreNearlyNothing) {
  const Camera camera{.eye = {0, 0, 1e-20}, .target = {1, 1e-13, 1e-20}, .near_plane = 0.1};
  EXPECT_EQ(fault(ahead(camera, {1e-20, 1e-40, 0}, 1, {.aside = 1e-20, .up = 0})), "");
}

/// Along an axis, where sums do not turn the line of sight.
TEST(Ahead, ParallelRays) {
  Camera camera{.eye = {0, 0, 2}, .target = {1, 0, 2}, .projection = Projection::orthographic};
  const FrameView view(ahead(camera, {0, 1, 0}, 2), 100);
  camera.eye.y = camera.target.y = 1.75;
  EXPECT_TRUE(holds_for(view, camera));
  camera.eye.y = camera.target.y = 2.25;
  EXPECT_FALSE(holds_for(view, camera));
}

}  // namespace ahead_test
