// SPDX-License-Identifier: MIT
#include "occlude/culler/shadow_margin.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <random>
#include <vector>

#include "frames.h"
#include "occlude/culler/culler.h"
#include "occlude/kernel/overlap.h"
#include "scenes.h"

namespace {

using namespace occlude;
using namespace occlude::culler;
using kernel::Relation;

constexpr double kShare = 0.01;

/// The corners of a box, moved in the picture by the margin towards `angle`.
std::vector<kernel::Vec3> moved(const kernel::Aabb& box, const Camera& camera, double margin, double angle) {
  const auto [right, up, forward] = camera.axes();
  const bool perspective = camera.projection == Projection::perspective;
  const double height = perspective ? 2 * std::tan(glm::radians(camera.fov_y_deg) / 2) : camera.height;
  std::vector<kernel::Vec3> corners;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 x{i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z};
    const double depth = perspective ? glm::dot(x - camera.eye, forward) : 1;
    const glm::dvec3 to = x + margin * height * depth * (std::cos(angle) * right + std::sin(angle) * up);
    corners.push_back({to.x, to.y, to.z});
  }
  return corners;
}

/// Whether the shadow holds the box however it is moved by `margin`.
bool holds_moved(const kernel::ShadowFrustum& shadow, const kernel::Aabb& box, const Camera& camera, double margin) {
  constexpr int kDirections = 256;
  for (int d = 0; d < kDirections; ++d) {
    for (const kernel::Vec3& corner : moved(box, camera, margin, 2 * std::numbers::pi * d / kDirections)) {
      if (kernel::overlap_certified(shadow, kernel::Aabb{corner, corner}).relation != Relation::inside) return false;
    }
  }
  return true;
}

class Margin : public testing::TestWithParam<Projection> {
 protected:
  /// Looks askew at a pentagon that stands askew.
  Margin() {
    camera_.eye = {1, 2, 3};
    camera_.target = {11, 3, 2};
    camera_.projection = GetParam();
    camera_.height = 12;
    const glm::dvec3 u{0.3, 1, 0.1}, v{-0.4, 0.2, 1};
    for (int i = 0; i < 5; ++i) {
      const double angle = 2 * std::numbers::pi * i / 5;
      const glm::dvec3 x = glm::dvec3{11, 3, 2} + 3 * std::cos(angle) * u + 2 * std::sin(angle) * v;
      loop_.push_back({x.x, x.y, x.z});
    }
  }

  [[nodiscard]] kernel::ShadowFrustum shadow(kernel::Near near) const {
    const glm::dvec3 forward = camera_.axes().forward;
    const auto viewpoint = GetParam() == Projection::perspective
                               ? kernel::Viewpoint::eye({camera_.eye.x, camera_.eye.y, camera_.eye.z})
                               : kernel::Viewpoint::direction({forward.x, forward.y, forward.z});
    return kernel::ShadowFrustum::make(viewpoint, loop_, near).frustum.value();
  }

  Camera camera_;
  std::vector<kernel::Vec3> loop_;
};

TEST_P(Margin, KeepsWhatStaysInTheShadowHoweverItIsMoved) {
  const ShadowMargin margin(camera_, kShare, 0);
  for (const kernel::Near near : {kernel::Near::surface, kernel::Near::farthest}) {
    const kernel::ShadowFrustum frustum = shadow(near);
    std::mt19937 random(11);
    int kept = 0, lost = 0;
    for (int i = 0; i < 4000; ++i) {
      const kernel::Vec3 low{uniform(random, 9, 40), uniform(random, -3, 9), uniform(random, -4, 8)};
      const kernel::Aabb box{
          low, {low.x + uniform(random, 0, 0.5), low.y + uniform(random, 0, 0.5), low.z + uniform(random, 0, 0.5)}};
      if (kernel::overlap_certified(frustum, box).relation != Relation::inside) continue;
      const glm::dvec3 half = 0.5 * glm::dvec3{box.max.x - low.x, box.max.y - low.y, box.max.z - low.z};
      const kernel::Obb same{{low.x + half.x, low.y + half.y, low.z + half.z},
                             {kernel::Vec3{half.x, 0, 0}, {0, half.y, 0}, {0, 0, half.z}}};
      const bool keeps = margin.keeps(frustum, box);
      EXPECT_EQ(margin.keeps(frustum, same), keeps);
      // A polygon of moves is less than the circle, by half of the square of its angle.
      EXPECT_EQ(holds_moved(frustum, box, camera_, kShare * (keeps ? 1 - 1e-9 : 1 + 1e-3)), keeps);
      ++(keeps ? kept : lost);
    }
    EXPECT_GT(kept, 100);
    EXPECT_GT(lost, 20);
  }
}

TEST_P(Margin, OfNoneIsTheShadowItself) {
  const kernel::ShadowFrustum frustum = shadow(kernel::Near::surface);
  const kernel::Aabb touching{{loop_[0].x, loop_[0].y, loop_[0].z}, {loop_[0].x, loop_[0].y, loop_[0].z}};
  EXPECT_TRUE(ShadowMargin().keeps(frustum, touching));
  EXPECT_TRUE(ShadowMargin(camera_, 0, 1e9).keeps(frustum, touching));
  EXPECT_FALSE(ShadowMargin(camera_, kShare, 0).keeps(frustum, touching));
}

INSTANTIATE_TEST_SUITE_P(Projections, Margin, testing::Values(Projection::perspective, Projection::orthographic));

/// A wall at distance 10 that hides 10 to each side, and one at 20 that reaches to `side`.
bool is_drawn_behind(double side, const CullOptions& options) {
  PolygonSoup soup;
  add_wall(soup, 10, -10, 10, -10, 10);
  add_wall(soup, 20, 0, side, -1, 1);
  const Culler culler = one_polygon_leaves(soup);
  return is_drawn(culler, look(culler, options), 1);
}

TEST(CullOptions, AMarginDrawsWhatIsHiddenByLess) {
  // At distance 20 the picture, opened by 60 degrees, is 40 tan 30 high; the shadow ends at 20.
  const double margin = kShare * 40 * std::tan(glm::radians(30.0));
  EXPECT_FALSE(is_drawn_behind(20, {}));
  EXPECT_FALSE(is_drawn_behind(20 - 1.01 * margin, {.margin = kShare}));
  EXPECT_TRUE(is_drawn_behind(20 - 0.99 * margin, {.margin = kShare}));
}

/// The wall is in two, side by side: only both together hide what is behind.
bool is_drawn_behind_two(double side, const CullOptions& options) {
  PolygonSoup soup;
  add_wall(soup, 10, -10, 0, -10, 10);
  add(soup, {{10, 0, -10}, {10.5, 10, -10}, {10.5, 10, 10}, {10, 0, 10}});
  add_wall(soup, 20, -side, side, -1, 1);
  const Culler culler = one_polygon_leaves(soup);
  return is_drawn(culler, look(culler, options), 2);
}

TEST(CullOptions, AMarginHoldsForTwoTogether) {
  const double margin = kShare * 40 * std::tan(glm::radians(30.0)), shadow = 20 * 10 / 10.5;
  EXPECT_TRUE(is_drawn_behind_two(15, {}));
  EXPECT_FALSE(is_drawn_behind_two(15, {.margin = kShare, .unions = true}));
  EXPECT_FALSE(is_drawn_behind_two(shadow - 0.1 * margin, {.unions = true}));
  EXPECT_TRUE(is_drawn_behind_two(shadow - 0.1 * margin, {.margin = kShare, .unions = true}));
}

}  // namespace
