// SPDX-License-Identifier: MIT
// Boxes in the coarse picture: no corner lies outside the bounds found for its box.
#include "cover/projected_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <limits>
#include <random>
#include <span>
#include <vector>

#include "camera/single_precision.h"
#include "exact_picture.h"
#include "model/bounds.h"
#include "scenes.h"

namespace projected_boxes_test {

using namespace occlude;
using namespace occlude::culler;

/// Where the corners of a box may be moved to.
std::vector<ExactSeen> corners(const ConservativeViewport& picture, const kernel::Aabb& box) {
  std::vector<ExactSeen> all;
  for (unsigned c = 0; c < 8; ++c) {
    const glm::dvec3 corner{(c & 1U) != 0 ? box.max[0] : box.min[0], (c & 2U) != 0 ? box.max[1] : box.min[1],
                            (c & 4U) != 0 ? box.max[2] : box.min[2]};
    for (const ExactSeen& seen : moved(picture, exact(picture, corner))) all.push_back(seen);
  }
  return all;
}

/// None of these points of box k lies beyond what is known of it. Returns how far the bounds lie beyond them to the left and
/// right at most.
Real expect_held(const ConservativeViewport& picture, const ProjectedBoxes& boxes, std::size_t k,
                 std::span<const ExactSeen> points) {
  Real low_x = 1e30L, high_x = -1e30L;
  for (const ExactSeen& point : points) {
    const auto [x, y, nearness] = exact_place(picture, point);
    low_x = std::min(low_x, x);
    high_x = std::max(high_x, x);
    EXPECT_LE(boxes.low_x[k], x);
    EXPECT_GE(boxes.high_x[k], x);
    EXPECT_LE(boxes.low_y[k], y);
    EXPECT_GE(boxes.high_y[k], y);
    if (x >= 0 && x < picture.width()) {
      EXPECT_TRUE(boxes.x0[k] <= x && x < boxes.x1[k]) << "pixels";
    }
    if (y >= 0 && y < picture.height()) {
      EXPECT_TRUE(boxes.y0[k] <= y && y < boxes.y1[k]) << "pixels";
    }
    EXPECT_GE(boxes.most[k], nearness);
    EXPECT_GT(point.forward, picture.near());
  }
  return std::max(low_x - boxes.low_x[k], boxes.high_x[k] - high_x);
}

/// Expects of each point that is not nearer than the picture shows that it is held. Returns how many there are.
std::size_t expect_held_all(const ConservativeViewport& picture, const ProjectedBoxes& batch,
                            const std::array<glm::dvec3, ProjectedBoxes::kMost>& points) {
  std::size_t known = 0;
  for (std::size_t k = 0; k < batch.size; ++k) {
    if (batch.most[k] == std::numeric_limits<float>::infinity()) continue;
    ++known;
    expect_held(picture, batch, k, std::array{exact(picture, points[k])});
  }
  return known;
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
    const ConservativeViewport picture(FrameView(camera, depth), {512, 288, 16}, i % 2 == 0 ? 0 : kSinglePrecision * depth);
    const BoxPicture boxes(picture, {0, 0});
    ProjectedBoxes batch;
    std::vector<kernel::Aabb> asked;
    for (std::size_t k = 0; k < ProjectedBoxes::kMost; ++k) {
      const glm::dvec3 middle = camera.eye + 20.0 * camera.axes().forward + point(25),
                       half = glm::abs(point(k % 2 == 0 ? 4 : 1e-3));
      asked.push_back({{middle.x - half.x, middle.y - half.y, middle.z - half.z},
                       {middle.x + half.x, middle.y + half.y, middle.z + half.z}});
      batch.add(boxes, asked.back());
    }
    batch.project(boxes);
    kernel::BoxBlock block;
    for (std::size_t k = 0; k < asked.size(); ++k) block.set(k, asked[k]);
    ProjectedBoxes of_block;
    of_block.project(boxes, block);
    for (std::size_t k = 0; k < batch.size; ++k) {
      ProjectedBoxes alone;
      alone.add(boxes, asked[k]);
      alone.project(boxes);
      EXPECT_EQ(alone.most[0], batch.most[k]) << "its lane decides";
      EXPECT_EQ(of_block.most[k], batch.most[k]) << "how it came there decides";
      EXPECT_EQ(of_block.low_x[k], batch.low_x[k]);
      EXPECT_EQ(of_block.y1[k], batch.y1[k]);
      EXPECT_EQ(alone.low_x[0], batch.low_x[k]);
      EXPECT_EQ(alone.y1[0], batch.y1[k]);
      if (batch.most[k] == std::numeric_limits<float>::infinity()) continue;
      ++known;
      if (expect_held(picture, batch, k, corners(picture, asked[k])) < 0.05 && away == 10) ++tight;
    }
  }
  EXPECT_GT(known, 500U);
  EXPECT_GT(tight, known / 3);
}

/// In a picture that is narrow, it is where points are relative to the eye that rounds. In a wide one it is where they are
/// in the picture.
TEST_P(SeenBoxesTest, HoldPointsInPicturesOfAnyWidth) {
  std::size_t known = 0;
  for (int i = 0; i < 60000; ++i) {
    Camera camera;
    camera.projection = GetParam();
    camera.eye = point(10);
    camera.target = camera.eye + point(1);
    const double tangent = std::exp2(uniform(-16, 6));  // of half of the angle
    camera.fov_y_deg = glm::degrees(2 * std::atan(tangent));
    camera.height = 2 * tangent;
    if (!fault(camera).empty()) continue;
    const ConservativeViewport picture(FrameView(camera, 2000), {512, 288, 16}, 0);
    const BoxPicture boxes(picture, {0, 0});
    const auto [right, up, forward] = camera.axes();
    ProjectedBoxes batch;
    std::array<glm::dvec3, ProjectedBoxes::kMost> asked;
    for (glm::dvec3& at : asked) {
      const double aside = std::min(tangent * std::exp2(uniform(-10, 4)), 500.0);
      at = camera.eye + forward + uniform(-aside, aside) * right + uniform(-aside, aside) * up;
      batch.add(boxes, {to_kernel(at), to_kernel(at)});
    }
    batch.project(boxes);
    known += expect_held_all(picture, batch, asked);
  }
  EXPECT_GT(known, 300000U);
}

/// Legal numbers may differ by 2^-152. Of such differences floats keep nothing.
TEST(ProjectedBoxes, HoldPointsThatUnderflow) {
  std::mt19937 random(11);
  const auto point = [&](double size) {
    return glm::dvec3{uniform(random, -size, size), uniform(random, -size, size), uniform(random, -size, size)};
  };
  Camera camera;
  camera.projection = Projection::orthographic;
  camera.height = 0x1p-100;
  std::size_t known = 0;
  for (int i = 0; i < 1000; ++i) {
    camera.eye = 0x1p-99 * glm::abs(point(1)) + 0x1p-99;
    camera.target = camera.eye + point(1);
    FrameView view(camera, 0);
    view.depth = std::exp2(uniform(random, -120, -100));
    view.near = -1;  // as with an oblique near plane
    const ConservativeViewport picture(view, {512, 288, 16}, 0);
    const BoxPicture boxes(picture, {0, 0});
    ProjectedBoxes batch;
    std::array<glm::dvec3, ProjectedBoxes::kMost> asked;
    for (glm::dvec3& at : asked) {
      at = camera.eye + 0x1p-148 * point(1);
      batch.add(boxes, {to_kernel(at), to_kernel(at)});
    }
    batch.project(boxes);
    known += expect_held_all(picture, batch, asked);
  }
  EXPECT_GT(known, 5000U);
}

TEST(ProjectedBoxes, NothingIsKnownOfWhatReachesBeforeTheNearPlane) {
  Camera camera;  // along +x
  const ConservativeViewport picture(FrameView(camera, 100), {128, 96, 16}, 0);
  const BoxPicture boxes(picture, {0, 0});
  ProjectedBoxes batch;
  batch.add(boxes, {{0.05, -1, -1}, {2, 1, 1}});
  batch.add(boxes, {{-2, -1, -1}, {2, 1, 1}});
  batch.add(boxes, {{0x1p100, -0x1p100, 0}, {0x1p100, 0x1p100, 0}});
  batch.add(boxes, {{2, -1, -1}, {3, 1, 1}});
  batch.project(boxes);
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(batch.most[0], kInfinity);
  EXPECT_EQ(batch.most[1], kInfinity);
  EXPECT_LT(batch.most[3], 0.5001F);
  EXPECT_GE(batch.most[3], 0.5F);
}

}  // namespace projected_boxes_test
