// SPDX-License-Identifier: MIT
// The coarse picture's bounds of errors: no point, wherever it is moved to, lies beyond them.
#include "cover/conservative_viewport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "base/rounded_float.h"
#include "camera/single_precision.h"
#include "exact_picture.h"
#include "sanitized.h"
#include "scenes.h"

namespace conservative_viewport_test {

using namespace occlude;
using namespace occlude::culler;

class ConservativeViewportTest : public testing::TestWithParam<Projection> {};

INSTANTIATE_TEST_SUITE_P(Both, ConservativeViewportTest, testing::Values(Projection::perspective, Projection::orthographic),
                         [](const auto& tested) {
                           return tested.param == Projection::perspective ? "Perspective" : "Orthographic";
                         });

/// Points are near or far, in the picture or far aside, and moved by up to a twentieth of how far away they are.
TEST_P(ConservativeViewportTest, BoundsHoldWhereverPointsAreMoved) {
  std::mt19937 random(5);
  Real largest_share = 0, least_lost = 1;
  for (int i = 0; i < 4000; ++i) {
    Camera camera;
    camera.projection = GetParam();
    camera.eye = random_point(random, 10);
    camera.target = camera.eye + random_point(random);
    camera.fov_y_deg = uniform(random, 5, 150);
    camera.height = uniform(random, 1, 40);
    if (!fault(camera).empty()) continue;
    const double depth = std::exp2(uniform(random, 6, 18));
    const ConservativeViewport picture(FrameView(camera, depth), {512, 288, 16},
                                       uniform(random, 0, kSinglePrecision * depth));
    const auto [right, up, forward] = camera.axes();
    const double away = picture.near() * std::exp2(uniform(random, 0, 8)), aside = away * std::exp2(uniform(random, -3, 4));
    const glm::dvec3 point =
        camera.eye + away * forward + uniform(random, -aside, aside) * right + uniform(random, -aside, aside) * up;
    const EyePoint seen = picture.eye_point(point);
    if (seen.forward < picture.near()) continue;
    const auto [place, error, found] = picture.corner(seen);
    EXPECT_EQ(found, seen.forward);
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

/// The part of a segment that is in the picture. Empty if `from` is beyond `to`.
struct Shares {
  Real from, to;
};
Shares in_picture(const ConservativeViewport& picture, const ExactPlace& a, const ExactPlace& b) {
  Shares shares{0, 1};
  const auto clip = [&](Real at, Real to, Real most) {
    const Real run = to - at;
    for (const Real side : {Real{0}, most}) {
      const Real outside = side == 0 ? -at : at - most, change = side == 0 ? -run : run;  // positive beyond the side
      if (change > 0) shares.to = std::min(shares.to, -outside / change);
      if (change < 0) shares.from = std::max(shares.from, -outside / change);
      if (change == 0 && outside > 0) shares.to = -1;
    }
  };
  clip(a.x, b.x, picture.width());
  clip(a.y, b.y, picture.height());
  return shares;
}

/// How far a point is from a segment, across or up.
Real distance(const ExactPlace& point, const PixelPosition& a, const PixelPosition& b) {
  Real low = 0, high = 1;
  const auto at = [&](Real t) {
    return std::max(std::fabs(a.x + t * (Real{b.x} - a.x) - point.x), std::fabs(a.y + t * (Real{b.y} - a.y) - point.y));
  };
  for (int i = 0; i < 200; ++i) {
    const Real third = (high - low) / 3;
    (at(low + third) <= at(high - third) ? high : low) = at(low + third) <= at(high - third) ? high - third : low + third;
  }
  return at(low);
}

/// Edges begin near the eye, far aside, where the error of a position is up to thousands of pixels, or pass the picture by.
TEST(ConservativeViewport, NoEdgeInThePictureIsOffByMoreThanItsError) {
  std::mt19937 random(8);
  int inside = 0, smaller = 0;
  Real largest_share = 0;
  for (int i = 0; i < unless_sanitized(20'000, 4000); ++i) {
    constexpr double kDepth = 0x1p20;
    Camera camera;
    camera.target = {1, 0, 0};
    camera.near_plane = 0x1p-10;
    camera.fov_y_deg = uniform(random, 20, 120);
    const ConservativeViewport picture(FrameView(camera, kDepth), {576, 360, 60},
                                       i % 4 == 0 ? 0 : kSinglePrecision * kDepth);
    const auto end = [&](double most_away) {
      const double away = picture.near() * std::exp2(uniform(random, 0, most_away));
      const double aside = std::exp2(uniform(random, -3, 12)) * std::max(away, picture.near() * 4);
      return glm::dvec3(away, uniform(random, -aside, aside), uniform(random, -aside, aside));
    };
    const glm::dvec3 near = end(3), far = end(14);
    const EyePoint p = picture.eye_point(near), q = picture.eye_point(far);
    if (std::min(p.forward, q.forward) < picture.near()) continue;
    const BoundedPosition a = picture.corner(p), b = picture.corner(q);
    const double error = picture.edge_error(a, b), most = std::max(a.error, b.error);
    ASSERT_LE(error, most);
    smaller += error < most / 2 ? 1 : 0;
    const auto froms = moved(picture, exact(picture, near)), tos = moved(picture, exact(picture, far));
    for (std::size_t move = 0; move < 16; ++move) {
      const ExactPlace from = exact_place(picture, froms[move % 8]),
                       to = exact_place(picture, tos[move < 8 ? move : random() % 8]);
      const Shares shares = in_picture(picture, from, to);
      if (shares.from > shares.to) continue;
      for (const Real share : {shares.from, (shares.from + shares.to) / 2, shares.to}) {
        const ExactPlace at{from.x + share * (to.x - from.x), from.y + share * (to.y - from.y), 0};
        const Real off = distance(at, a.place, b.place);
        ASSERT_LE(off, error) << i;
        largest_share = std::max(largest_share, off / error);
        ++inside;
      }
    }
  }
  EXPECT_GT(inside, unless_sanitized(10'000, 2000));
  EXPECT_GT(smaller, unless_sanitized(2000, 400));
  EXPECT_GT(largest_share, 0.4);
}

/// Points on one ray have the same position, even where `up` is nearly parallel to the line of sight.
TEST(ConservativeViewport, ParallelRaysKeepTheirPlace) {
  std::mt19937 random(3);
  constexpr double kDepth = 0x1p10;
  for (int i = 0; i < 1000; ++i) {
    Camera camera;
    camera.aspect = 2;
    camera.height = 8;
    camera.projection = Projection::orthographic;
    camera.target = random_point(random);
    camera.up = camera.target + std::ldexp(1.0, -static_cast<int>(random() % 28)) * random_point(random);
    if (!fault(camera).empty()) continue;
    const ConservativeViewport picture(FrameView(camera, kDepth), {160, 96, 16}, 0);
    const glm::dvec3 near = random_point(random), far = near + 0x1p8 * camera.axes().forward;
    const BoundedPosition a = picture.corner(picture.eye_point(near)), b = picture.corner(picture.eye_point(far));
    EXPECT_NEAR(a.place.x, b.place.x, a.error + b.error) << i;
    EXPECT_NEAR(a.place.y, b.place.y, a.error + b.error) << i;
  }
}

}  // namespace conservative_viewport_test
