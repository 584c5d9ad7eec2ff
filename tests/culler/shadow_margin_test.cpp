// SPDX-License-Identifier: MIT
#include "camera/shadow_margin.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "camera/frame_view.h"
#include "camera/single_precision.h"
#include "frames.h"
#include "model/bounds.h"
#include "occlude/culler/culler.h"
#include "occlude/kernel/overlap.h"
#include "sanitized.h"
#include "scenes.h"

namespace shadow_margin_test {

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

TEST(Depth, IsNoLessThanThatOfAnyCorner) {
  const kernel::Aabb box{{-1, -2, -3}, {3, 2, 1}};
  for (const glm::dvec3& eye : {glm::dvec3{0, 0, 0}, {10, 10, 10}, {-5, 0, 7}, {0, 9, 0}}) {
    for (unsigned i = 0; i < 8; ++i) {
      const glm::dvec3 corner{i & 1U ? box.max.x : box.min.x, i & 2U ? box.max.y : box.min.y,
                              i & 4U ? box.max.z : box.min.z};
      EXPECT_GE(depth(box, eye), glm::distance(corner, eye));
    }
  }
}

class Margin : public testing::TestWithParam<Projection> {
 protected:
  /// A camera that looks obliquely at a pentagon that stands obliquely.
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

  /// A point behind one near the middle of the pentagon, beyond the near plane by less than a unit.
  [[nodiscard]] kernel::Vec3 beyond_near_plane(const kernel::ShadowFrustum& shadow, std::mt19937& random) const {
    const glm::dvec3 middle = camera_.target + glm::dvec3{uniform(random, -0.1, 0.1), uniform(random, -1, 1), 0};
    const glm::dvec3 ray = GetParam() == Projection::perspective ? middle - camera_.eye : camera_.axes().forward;
    const kernel::HalfSpace near = shadow.rounded_plane(0);
    const glm::dvec3 normal = to_glm(near.normal), from_origin = middle - to_glm(shadow.origin());
    const double to_plane = -(glm::dot(normal, from_origin) + near.offset) / glm::dot(normal, ray);
    return to_kernel(middle + (to_plane + uniform(random, 0, 1) / glm::length(ray)) * ray);
  }

  Camera camera_;
  std::vector<kernel::Vec3> loop_;
};

/// The boxes are anywhere behind the pentagon and beside it, or just beyond the near plane of its shadow.
TEST_P(Margin, KeepsWhatStaysInTheShadowHoweverItIsMoved) {
  const ShadowMargin margin(FrameView(camera_, 0), kShare);
  for (const kernel::Near near : {kernel::Near::surface, kernel::Near::farthest}) {
    const kernel::ShadowFrustum frustum = shadow(near);
    std::mt19937 random(11);
    int kept = 0, lost = 0, lost_to_the_near_plane = 0;
    for (int i = 0; i < unless_sanitized(8000, 2000); ++i) {
      const bool is_near = i % 2 == 1;
      const kernel::Vec3 low = is_near
                                   ? beyond_near_plane(frustum, random)
                                   : kernel::Vec3{uniform(random, 9, 40), uniform(random, -3, 9), uniform(random, -4, 8)};
      const double size = is_near ? 0.01 : 0.5;
      const kernel::Aabb box{
          low, {low.x + uniform(random, 0, size), low.y + uniform(random, 0, size), low.z + uniform(random, 0, size)}};
      if (kernel::overlap_certified(frustum, box).relation != Relation::inside) continue;
      const glm::dvec3 half = 0.5 * glm::dvec3{box.max.x - low.x, box.max.y - low.y, box.max.z - low.z};
      const kernel::Obb same{{low.x + half.x, low.y + half.y, low.z + half.z},
                             {kernel::Vec3{half.x, 0, 0}, {0, half.y, 0}, {0, 0, half.z}}};
      const bool keeps = margin.keeps(frustum, box);
      EXPECT_EQ(margin.keeps(frustum, same), keeps);
      // The moves form a polygon, which is smaller than the circle by half of the square of its angle.
      EXPECT_EQ(holds_moved(frustum, box, camera_, kShare * (keeps ? 1 - 1e-9 : 1 + 1e-3)), keeps);
      ++(keeps ? kept : lost);
      lost_to_the_near_plane += is_near && !keeps ? 1 : 0;
    }
    EXPECT_GT(kept, unless_sanitized(100, 25));
    EXPECT_GT(lost, unless_sanitized(20, 5));
    // With parallel rays, no move in the picture changes how far along the rays something is.
    const bool is_across = near == kernel::Near::farthest && GetParam() == Projection::orthographic;
    EXPECT_EQ(lost_to_the_near_plane > unless_sanitized(100, 25), !is_across) << lost_to_the_near_plane;
  }
}

TEST_P(Margin, OfNoneIsTheShadowItself) {
  const kernel::ShadowFrustum frustum = shadow(kernel::Near::surface);
  const kernel::Aabb touching{{loop_[0].x, loop_[0].y, loop_[0].z}, {loop_[0].x, loop_[0].y, loop_[0].z}};
  EXPECT_TRUE(ShadowMargin().keeps(frustum, touching));
  EXPECT_TRUE(ShadowMargin(FrameView(camera_, 1e9), 0).keeps(frustum, touching));
  EXPECT_FALSE(ShadowMargin(FrameView(camera_, 0), kShare).keeps(frustum, touching));
}

INSTANTIATE_TEST_SUITE_P(Projections, Margin, testing::Values(Projection::perspective, Projection::orthographic));

/// A slanted wall whose distance is 10 to 20, and points behind it, for a renderer that moves positions by 0.01. Moved
/// positions of the wall move its shadow in the picture, most at the vertices (10, -10, -10) and (10, -10, 10). Moved
/// positions of the points and of the planes count in addition, along the normals of the planes.
TEST(ShadowMargin, AllowsForPositionsInSinglePrecision) {
  constexpr double kRounding = 0.01, kDepth = kRounding / kSinglePrecision, kNone = 1e-12;
  const std::vector<kernel::Vec3> wall{{10, -10, -10}, {20, 20, -20}, {20, 20, 20}, {10, -10, 10}};
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    const bool perspective = projection == Projection::perspective;
    Camera camera;
    camera.projection = projection;
    const auto shadow = kernel::ShadowFrustum::make(camera.viewpoint(), wall, kernel::Near::surface).frustum.value();
    const ShadowMargin margin(FrameView(camera, kDepth), kNone);
    const auto keeps = [&](double x, double y) { return margin.keeps(shadow, kernel::Aabb{{x, y, 0}, {x, y, 0}}); };
    const double turn = kRounding * std::sqrt(300) / (10 * (10 - kRounding));
    // The sides are x >= y and 20 >= y.
    const double side =
        perspective ? 40 - 40 * turn - kRounding * (std::sqrt(2) + std::hypot(1 - turn, 1)) : 20 - kRounding - 2 * kRounding;
    EXPECT_TRUE(keeps(40, side - 1e-6));
    EXPECT_FALSE(keeps(40, side + 1e-6));
    // The near plane is 3 x - y >= 40.
    const double near = perspective ? (40 + kRounding * (std::sqrt(10) + std::hypot(3 - turn, 1))) / (3 - turn)
                                    : (40 + 2 * kRounding * std::sqrt(10) + kRounding) / 3;
    EXPECT_TRUE(keeps(near + 1e-6, 0));
    EXPECT_FALSE(keeps(near - 1e-6, 0));
  }
}

/// Walls that reach far aside or stand close to the eye, whose sides a renderer moves along the border of the picture by
/// more than their distance tells: both a vertex and the point behind it move across the side of the shadow.
TEST(ShadowMargin, AllowsForVerticesThatMoveFarAsideAndNearTheEye) {
  constexpr double kRounding = 0.01, kDepth = kRounding / kSinglePrecision, kNone = 1e-12, kX = 100;
  for (const auto& [distance, aside] : {std::pair{10.0, 1.0}, {10.0, 30.0}, {0.05, 0.01}, {0.05, 0.2}, {0.015, 0.001}}) {
    const auto shadow = [](double x, double y) {
      const std::vector<kernel::Vec3> wall{{x, -y, -y}, {x, y, -y}, {x, y, y}, {x, -y, y}};
      return kernel::ShadowFrustum::make(kernel::Viewpoint::eye({0, 0, 0}), wall, kernel::Near::surface).frustum.value();
    };
    const auto point = [](double x, double y) { return kernel::Aabb{{x, y, 0}, {x, y, 0}}; };
    const kernel::ShadowFrustum exact = shadow(distance, aside);
    const ShadowMargin margin(FrameView(Camera{}, kDepth), kNone);
    double kept = 0, lost = kX * aside / distance;
    for (int i = 0; i < 60; ++i) {
      const double middle = (kept + lost) / 2;
      (margin.keeps(exact, point(kX, middle)) ? kept : lost) = middle;
    }
    const double length = std::hypot(distance, aside), to_x = -kRounding * aside / length,
                 to_y = kRounding * distance / length;
    const kernel::ShadowFrustum moved = shadow(distance - to_x, aside - to_y);
    EXPECT_EQ(kernel::overlap_certified(moved, point(kX + to_x, kept + to_y)).relation, Relation::inside)
        << distance << " " << aside;
  }
}

/// Two walls that meet in the picture, at distances 20 and 5, and points behind both. Moved positions move the shadow of the
/// nearer wall more, whichever of the two comes first.
TEST(ShadowMargin, OfTwoIsThatOfTheNearer) {
  constexpr double kRounding = 0.01, kDepth = kRounding / kSinglePrecision, kNone = 1e-12;
  const Camera camera;
  const auto shadow = [&](const std::vector<kernel::Vec3>& wall) {
    return kernel::ShadowFrustum::make(camera.viewpoint(), wall, kernel::Near::surface).frustum.value();
  };
  const auto far = shadow({{20, -20, -20}, {20, 0, -20}, {20, 0, 20}, {20, -20, 20}});
  const auto near = shadow({{5, 0, -5}, {5, 5, -5}, {5, 5, 5}, {5, 0, 5}});
  const ShadowMargin margin(FrameView(camera, kDepth), kNone);
  // The side is x >= y, and the box is grown along both axes.
  const double side = 40 - 2 * (40 * kRounding * std::sqrt(75) / (5 * (5 - kRounding)) + 2 * kRounding);
  for (const kernel::ShadowUnion& both : {kernel::ShadowUnion{far, near}, kernel::ShadowUnion{near, far}}) {
    const auto keeps = [&](double y) { return margin.keeps(both, kernel::Aabb{{40, -1, 0}, {40, y, 0}}); };
    EXPECT_TRUE(keeps(side - 1e-6));
    EXPECT_FALSE(keeps(side + 1e-6));
  }
}

/// A wall at distance 10 that reaches 10 to each side, and one at distance 20 that reaches to `side`.
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
  EXPECT_FALSE(is_drawn_behind(20, {.method = Method::frusta}));
  EXPECT_FALSE(is_drawn_behind(20 - 1.01 * margin, {.method = Method::frusta, .margin = kShare}));
  EXPECT_TRUE(is_drawn_behind(20 - 0.99 * margin, {.method = Method::frusta, .margin = kShare}));
}

TEST(CullOptions, AMarginHoldsForQueries) {
  const double margin = kShare * 40 * std::tan(glm::radians(30.0));
  PolygonSoup soup;
  add_wall(soup, 10, -10, 10, -10, 10);
  const Culler culler(soup);
  const auto point_at = [](double y) { return Box(kernel::Aabb{{20, y, 0}, {20, y, 0}}); };
  View view;
  culler.cull(Camera{}, {.method = Method::frusta}, view);
  EXPECT_EQ(view.visibility(point_at(20 - 0.99 * margin)), Visibility::occluded);
  Camera wide;
  wide.fov_y_deg = 120;
  culler.cull(wide, {.method = Method::frusta, .margin = kShare}, view);  // the margin is the frame's own
  culler.cull(Camera{}, {.method = Method::frusta, .margin = kShare}, view);
  EXPECT_EQ(view.visibility(point_at(20 - 0.99 * margin)), Visibility::visible);
  EXPECT_EQ(view.visibility(point_at(20 - 1.01 * margin)), Visibility::occluded);
}

TEST(CullOptions, AMarginIsThatOfEachFrame) {
  PolygonSoup soup;
  add_wall(soup, 10, -10, 10, -10, 10);
  for (int y = -60; y < 60; ++y) add_wall(soup, 20, 0.5 * y, 0.5 * y + 0.4, -1, 1);
  const Culler culler = one_polygon_leaves(soup);
  View view;
  int drawn_for_the_margin = 0;
  for (int i = 0; i < 40; ++i) {
    Camera camera;
    camera.eye = {0.1 * i, 3 * std::sin(i), 0};
    camera.target = {20, 0, 0};
    const CullOptions options{
        .method = Method::frusta, .objective = {.coherence = 0}, .margin = i % 3 == 0 ? 0 : 0.02};  // as wide as a wall
    CullOptions without = options;
    without.margin = 0;
    const CullResult& frame = culler.cull(camera, options, view);
    const CullResult alone = culler.cull(camera, options);  // by a view that has seen no other frame
    EXPECT_EQ(frame.drawn, alone.drawn) << i;
    drawn_for_the_margin += alone.drawn != culler.cull(camera, without).drawn;
  }
  EXPECT_GT(drawn_for_the_margin, 5);
}

/// The same with a wall in two halves, which only together hide what is behind.
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
  EXPECT_TRUE(is_drawn_behind_two(15, {.method = Method::frusta}));
  EXPECT_FALSE(is_drawn_behind_two(15, {.method = Method::frusta, .margin = kShare, .unions = true}));
  EXPECT_FALSE(is_drawn_behind_two(shadow - 0.1 * margin, {.method = Method::frusta, .unions = true}));
  EXPECT_TRUE(is_drawn_behind_two(shadow - 0.1 * margin, {.method = Method::frusta, .margin = kShare, .unions = true}));
}

}  // namespace shadow_margin_test
