// SPDX-License-Identifier: MIT
// Boxes in the coarse picture: no corner lies outside the bounds found for its box.
#include "seen_boxes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace seen_boxes_test {

using namespace occlude;
using namespace occlude::culler;

using Real = long double;

struct Exact {
  Real right, up, forward;
};

Exact exact(const BeamPicture& picture, const glm::dvec3& point) {
  const auto along = [&](const glm::dvec3& axis) {
    Real sum = 0;
    for (int i = 0; i < 3; ++i) sum += Real{axis[i]} * (Real{point[i]} - Real{picture.eye()[i]});
    return sum;
  };
  return {along(picture.right()), along(picture.up()), along(picture.forward())};
}

class SeenBoxesTest : public testing::TestWithParam<Projection> {
 protected:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  glm::dvec3 point(double size) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }

  std::mt19937 random_{11};
};

INSTANTIATE_TEST_SUITE_P(Both, SeenBoxesTest, testing::Values(Projection::perspective, Projection::orthographic),
                         [](const auto& tested) {
                           return tested.param == Projection::perspective ? "Perspective" : "Orthographic";
                         });

TEST_P(SeenBoxesTest, HoldTheirCorners) {
  std::size_t known = 0, tight = 0;
  for (int i = 0; i < 400; ++i) {
    Camera camera;
    camera.projection = GetParam();
    const double away = i % 3 == 0 ? 1e6 : 10;
    camera.eye = point(away);
    camera.target = camera.eye + point(1);
    camera.fov_y_deg = uniform(5, 120);
    camera.height = uniform(1, 40);
    camera.aspect = uniform(0.5, 2);
    if (!fault(camera).empty()) continue;
    const double depth = 3 * away + 300;
    const BeamPicture picture(FrameView(camera, depth), {512, 288, 16}, i % 2 == 0 ? 0 : 1e-6);
    const BoxPicture boxes(picture, {0, 0});
    SeenBoxes batch;
    std::vector<kernel::Aabb> asked;
    for (std::size_t k = 0; k < SeenBoxes::kMost; ++k) {
      const glm::dvec3 middle = camera.eye + 20.0 * camera.axes().forward + point(25),
                       half = glm::abs(point(k % 2 == 0 ? 4 : 1e-3));
      asked.push_back({{middle.x - half.x, middle.y - half.y, middle.z - half.z},
                       {middle.x + half.x, middle.y + half.y, middle.z + half.z}});
      batch.add(boxes, asked.back());
    }
    batch.see(boxes);
    kernel::BoxBlock block;
    for (std::size_t k = 0; k < asked.size(); ++k) block.set(k, asked[k]);
    const SeenBoxes of_block(boxes, block);
    for (std::size_t k = 0; k < batch.size; ++k) {
      SeenBoxes alone;
      alone.add(boxes, asked[k]);
      alone.see(boxes);
      EXPECT_EQ(alone.most[0], batch.most[k]) << "its lane decides";
      EXPECT_EQ(of_block.most[k], batch.most[k]) << "how it came there decides";
      EXPECT_EQ(of_block.low_x[k], batch.low_x[k]);
      EXPECT_EQ(of_block.y1[k], batch.y1[k]);
      EXPECT_EQ(alone.low_x[0], batch.low_x[k]);
      EXPECT_EQ(alone.y1[0], batch.y1[k]);
      if (batch.most[k] == std::numeric_limits<float>::infinity()) continue;
      ++known;
      Real low_x = 1e30L, high_x = -1e30L;
      for (unsigned c = 0; c < 8; ++c) {
        const Exact seen =
            exact(picture, {(c & 1U) ? asked[k].max[0] : asked[k].min[0], (c & 2U) ? asked[k].max[1] : asked[k].min[1],
                            (c & 4U) ? asked[k].max[2] : asked[k].min[2]});
        EXPECT_GT(seen.forward, picture.near());
        const Real shrink = picture.is_perspective() ? 1 / seen.forward : 1;
        const Real x = picture.middle().x + picture.scale().x * seen.right * shrink;
        const Real y = picture.middle().y + picture.scale().y * seen.up * shrink;
        low_x = std::min(low_x, x);
        high_x = std::max(high_x, x);
        EXPECT_LE(batch.low_x[k], x);
        EXPECT_GE(batch.high_x[k], x);
        EXPECT_LE(batch.low_y[k], y);
        EXPECT_GE(batch.high_y[k], y);
        if (x >= 0 && x < 512) {
          EXPECT_TRUE(batch.x0[k] <= x && x < batch.x1[k]) << "pixels";
        }
        if (y >= 0 && y < 288) {
          EXPECT_TRUE(batch.y0[k] <= y && y < batch.y1[k]) << "pixels";
        }
        EXPECT_GE(batch.most[k], picture.is_perspective() ? shrink : -seen.forward);
      }
      if (away == 10 && low_x - batch.low_x[k] < 0.05 && batch.high_x[k] - high_x < 0.05) ++tight;
    }
  }
  EXPECT_GT(known, 500U);
  EXPECT_GT(tight, known / 3);
}

TEST(SeenBoxes, NothingIsKnownOfWhatReachesBeforeTheNearPlane) {
  Camera camera;  // along +x
  const BeamPicture picture(FrameView(camera, 100), {128, 96, 16}, 0);
  const BoxPicture boxes(picture, {0, 0});
  SeenBoxes batch;
  batch.add(boxes, {{0.05, -1, -1}, {2, 1, 1}});
  batch.add(boxes, {{-2, -1, -1}, {2, 1, 1}});
  batch.add(boxes, {{0x1p100, -0x1p100, 0}, {0x1p100, 0x1p100, 0}});
  batch.add(boxes, {{2, -1, -1}, {3, 1, 1}});
  batch.see(boxes);
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(batch.most[0], kInfinity);
  EXPECT_EQ(batch.most[1], kInfinity);
  EXPECT_LT(batch.most[3], 0.5001F);
  EXPECT_GE(batch.most[3], 0.5F);
}

}  // namespace seen_boxes_test
