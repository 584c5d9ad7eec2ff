// SPDX-License-Identifier: MIT
// Planes of triangles in the coarse picture: no ray meets a triangle, wherever its vertices are moved to, farther away than
// its bound says.
#include "cover/projected_plane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "camera/single_precision.h"
#include "exact_picture.h"
#include "scenes.h"

namespace projected_plane_test {

using namespace occlude;
using namespace occlude::culler;

using Vector = glm::vec<3, Real>;

class SeenPlaneTest : public testing::TestWithParam<Projection> {
 protected:
  double uniform(double low, double high) { return culler::uniform(random_, low, high); }
  glm::dvec3 point(double size) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }
  /// Corners in the picture, some of which are nearly in line. Their distances differ by up to 1000 times.
  std::array<glm::dvec3, 3> triangle(const Camera& camera) {
    const auto [right, up, forward] = camera.axes();
    const double flat = std::exp2(uniform(-20, 0)), slant = uniform(-1, 1);
    std::array<glm::dvec3, 3> corners;
    for (glm::dvec3& corner : corners) {
      const double away = std::exp2(uniform(0, 10)), x = uniform(-1, 1), y = slant * x + flat * uniform(-1, 1);
      corner = camera.eye + away * forward + (GetParam() == Projection::perspective ? away : 1) * (x * right + y * up);
    }
    return corners;
  }

  std::mt19937 random_{17};
};

INSTANTIATE_TEST_SUITE_P(Both, SeenPlaneTest, testing::Values(Projection::perspective, Projection::orthographic),
                         [](const auto& tested) {
                           return tested.param == Projection::perspective ? "Perspective" : "Orthographic";
                         });

/// A lower bound of the nearness along the ray that meets a point. It leaves out what lower() takes off for roundings of the
/// scale and the product.
Real bound_at(const ConservativeViewport& picture, const PlaneBound& bound, const Vector& at) {
  const Real shrink = picture.is_perspective() ? 1 / at.z : 1;
  return (bound.constant + bound.of_x * at.x * shrink + bound.of_y * at.y * shrink) * bound.scale;
}

/// Every other renderer moves vertices, all alike or each by itself.
TEST_P(SeenPlaneTest, BoundsHoldWhereverVerticesAreMoved) {
  std::size_t known = 0, tight = 0;
  for (int i = 0; i < 20000; ++i) {
    Camera camera;
    camera.projection = GetParam();
    camera.eye = point(10);
    camera.target = camera.eye + point(1);
    camera.fov_y_deg = 100;
    camera.height = 4;
    if (!fault(camera).empty()) continue;
    const std::array<glm::dvec3, 3> corners = triangle(camera);
    double depth = 0;
    for (const glm::dvec3& corner : corners) depth = std::max(depth, glm::dot(glm::abs(corner - camera.eye), glm::dvec3(1)));
    const ConservativeViewport picture(FrameView(camera, depth), {512, 288, 16}, i % 2 == 0 ? 0 : kSinglePrecision * depth);
    std::array<EyePoint, 3> seen;
    std::ranges::transform(corners, seen.begin(), [&](const glm::dvec3& corner) { return picture.eye_point(corner); });
    const PixelPosition high = picture.slope(512, 288);
    const ProjectedPlane plane(picture, high.x + high.y, seen[0], seen[1], seen[2]);
    if (!plane.is_known()) continue;
    ++known;
    for (std::size_t m = 0; m < 16; ++m) {
      std::array<Vector, 3> to;
      for (std::size_t k = 0; k < 3; ++k) {
        const ExactSeen vertex = moved(picture, exact(picture, corners[k]))[m < 8 ? m : random_() % 8];
        to[k] = {vertex.right, vertex.up, vertex.forward};
      }
      const Real a = uniform(0, 1), b = uniform(0, 1) * (1 - a);
      for (const Vector& at : {to[0], to[1], to[2], a * to[0] + b * to[1] + (1 - a - b) * to[2]}) {
        const Real truth = picture.is_perspective() ? 1 / at.z : -at.z,
                   found = bound_at(picture, *plane.bounds(0).begin(), at);
        ASSERT_LE(found - 0x1p-50L * std::fabs(found), truth) << i << ' ' << m;
        tight += truth - found < 1e-6 * std::fabs(truth) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(known, 19000U);
  EXPECT_GT(tight, known * 4);
}

}  // namespace projected_plane_test
