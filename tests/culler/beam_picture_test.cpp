// SPDX-License-Identifier: MIT
// The coarse picture's bounds of errors: no point, wherever it is moved to, lies beyond them.
#include "beam_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "exact_picture.h"
#include "rounded_float.h"
#include "scenes.h"
#include "single_precision.h"

namespace beam_picture_test {

using namespace occlude;
using namespace occlude::culler;

glm::dvec3 some(std::mt19937& random, double size = 1) {
  return {uniform(random, -size, size), uniform(random, -size, size), uniform(random, -size, size)};
}

class BeamPictureTest : public testing::TestWithParam<Projection> {};

INSTANTIATE_TEST_SUITE_P(Both, BeamPictureTest, testing::Values(Projection::perspective, Projection::orthographic),
                         [](const auto& tested) {
                           return tested.param == Projection::perspective ? "Perspective" : "Orthographic";
                         });

/// Points are near or far, in the picture or far aside, and moved by up to a twentieth of how far away they are.
TEST_P(BeamPictureTest, BoundsHoldWhereverPointsAreMoved) {
  std::mt19937 random(5);
  Real largest_share = 0, least_lost = 1;
  for (int i = 0; i < 4000; ++i) {
    Camera camera;
    camera.projection = GetParam();
    camera.eye = some(random, 10);
    camera.target = camera.eye + some(random);
    camera.fov_y_deg = uniform(random, 5, 150);
    camera.height = uniform(random, 1, 40);
    if (!fault(camera).empty()) continue;
    const double depth = std::exp2(uniform(random, 6, 18));
    const BeamPicture picture(FrameView(camera, depth), {512, 288, 16}, uniform(random, 0, kSinglePrecision * depth));
    const auto [right, up, forward] = camera.axes();
    const double away = picture.near() * std::exp2(uniform(random, 0, 8)), aside = away * std::exp2(uniform(random, -3, 4));
    const glm::dvec3 point =
        camera.eye + away * forward + uniform(random, -aside, aside) * right + uniform(random, -aside, aside) * up;
    const Seen seen = picture.see(point);
    if (seen.forward < picture.near()) continue;
    const auto [place, error] = picture.corner(seen);
    const float nearness = rounded_down(picture.least_nearness(seen.forward));
    for (const ExactSeen& to : moved(picture, exact(picture, point))) {
      const ExactPlace exact = exact_place(picture, to);
      ASSERT_LE(std::fabs(exact.x - place.x), error) << i;
      ASSERT_LE(std::fabs(exact.y - place.y), error) << i;
      ASSERT_GE(exact.nearness, nearness) << i;
      largest_share = std::max(largest_share, std::fabs(exact.x - place.x) / error);
      least_lost = std::min(least_lost, (exact.nearness - nearness) / std::fabs(exact.nearness));
    }
  }
  EXPECT_GT(largest_share, 0.99);
  EXPECT_LT(least_lost, 0x1p-22);
}

/// Points on one ray have the same position, even where `up` is nearly parallel to the line of sight.
TEST(BeamPicture, ParallelRaysKeepTheirPlace) {
  std::mt19937 random(3);
  constexpr double kDepth = 0x1p10;
  for (int i = 0; i < 1000; ++i) {
    Camera camera;
    camera.aspect = 2;
    camera.height = 8;
    camera.projection = Projection::orthographic;
    camera.target = some(random);
    camera.up = camera.target + std::ldexp(1.0, -static_cast<int>(random() % 28)) * some(random);
    if (!fault(camera).empty()) continue;
    const BeamPicture picture(FrameView(camera, kDepth), {160, 96, 16}, 0);
    const glm::dvec3 near = some(random), far = near + 0x1p8 * camera.axes().forward;
    const Corner a = picture.corner(picture.see(near)), b = picture.corner(picture.see(far));
    EXPECT_NEAR(a.place.x, b.place.x, a.error + b.error) << i;
    EXPECT_NEAR(a.place.y, b.place.y, a.error + b.error) << i;
  }
}

}  // namespace beam_picture_test
