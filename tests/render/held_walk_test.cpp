// SPDX-License-Identifier: MIT
// The frames of a walk that holds.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>
#include <tuple>
#include <vector>

#include "held/held_model.h"
#include "held_along_path.h"
#include "occlude/render/city.h"
#include "occlude/render/errors.h"
#include "occlude/render/frames_along_path.h"
#include "occlude/render/view_planes.h"
#include "occlude/render/why.h"

namespace occlude::render {
namespace held_walk_test {

std::vector<bool> drawn_of(const culler::CullResult& result, std::size_t polygons) {
  std::vector<bool> drawn(polygons);
  for (const auto& [first, count] : result.drawn) {
    for (std::uint32_t p = first; p < first + count; ++p) drawn[p] = true;
  }
  return drawn;
}

/// What a frame tells, to be compared.
auto told(const culler::CullResult& result) {
  std::vector<std::tuple<std::uint32_t, culler::Culled::By, std::uint32_t, std::uint32_t>> culled;
  for (const culler::Culled& c : result.culled) culled.emplace_back(c.node, c.by, c.index, c.second);
  return culled;
}

class HeldWalk : public testing::TestWithParam<culler::Method> {
 protected:
  HeldWalk() {
    options_.cull.method = GetParam();
    options_.hold = 4;
    options_.render = false;
  }

  WalkOptions options_;
  City city_ = generate_city(20'000, 1);
  std::size_t frames_ = 60;
};

// CullResult, 1 and 2; and a frame is culled as the library does that draws it.
TEST_P(HeldWalk, DrawsWhatTheRegionDrawsInTheFramesOwnView) {
  const culler::Culler culler = make_culler(city_.soup, options_);
  const std::size_t polygons = culler.hierarchy().soup().size();
  FramesAlongPath along(culler, city_.path, options_);
  culler::View of_region, alone;
  std::size_t by_own_view = 0, hidden = 0;
  for (std::size_t frame = 0; frame < frames_; ++frame) {
    along.go_to(frame);
    along.cull();
    const culler::CullResult& result = along.result();
    const CulledFor source = along.source();
    const culler::Camera camera = city_.path.camera(frame, aspect(options_));
    ASSERT_GT(along.region(), 0U) << frame;
    ASSERT_FALSE(source.camera.eyes.is_point());
    const std::vector<bool> in_view =
        drawn_of(culler.cull(camera, {.method = culler::Method::frusta, .occluders = 0}, alone), polygons);
    const std::vector<bool> in_region = drawn_of(source.result, polygons), drawn = drawn_of(result, polygons);
    std::size_t count = 0, view_culled = 0, shadow_culled = 0;
    for (std::uint32_t p = 0; p < polygons; ++p) {
      ASSERT_EQ(drawn[p], in_view[p] && in_region[p]) << frame << ' ' << p;
      const culler::Culled* const cull = culler.cull_of(result, p);
      ASSERT_EQ(cull == nullptr, bool{drawn[p]}) << frame << ' ' << p;
      if (!cull) {
        ++count;
      } else if (cull->by == culler::Culled::By::view) {
        ++view_culled;
        ASSERT_GT(beyond_view(culler, result, *cull), 0) << frame << ' ' << p;
        by_own_view += cull->index < view_planes_of(camera);
        ASSERT_LT(cull->index, result.view.size());
      } else {
        ++shadow_culled;
      }
    }
    EXPECT_EQ(result.stats.drawn_polygons, count);
    EXPECT_EQ(result.stats.view_culled_polygons, view_culled);
    EXPECT_EQ(result.stats.shadow_culled_polygons, shadow_culled);
    hidden += shadow_culled;

    culler::HeldRegion region;
    region.cull(culler, std::span(&source.camera, 1), source.options, of_region);
    ASSERT_TRUE(region.holds_for(camera)) << frame;
    std::vector<kernel::HalfSpace> planes;
    culler::to_planes(std::span(result.view).first(view_planes_of(camera)), planes);
    culler::HeldResult listed;
    region.leaves().list(planes, listed);
    if (GetParam() == culler::Method::cover) {  // frusta depend on the frames before
      EXPECT_EQ(listed.drawn_polygons, result.stats.drawn_polygons) << frame;
    }
  }
  EXPECT_GT(by_own_view, 0U);
  EXPECT_GT(hidden, 0U);
}

// Of two cameras that look away from each other, so that the half-spaces of both cut something off.
TEST_P(HeldWalk, WhatIsCulledByEitherIsCulledByItsOwnReason) {
  const culler::Culler culler = make_culler(city_.soup, options_);
  const std::size_t polygons = culler.hierarchy().soup().size();
  for (const double degrees : {10.0, 90.0, 180.0}) {
    culler::Camera camera = city_.path.camera(40, aspect(options_)), other = camera;
    const glm::dvec3 sight = camera.target - camera.eye;
    const double angle = degrees * std::numbers::pi / 180;
    other.target = other.eye + std::cos(angle) * sight + std::sin(angle) * glm::cross(camera.up, sight);
    const culler::CullResult own = culler.cull(camera, {.method = culler::Method::frusta, .occluders = 0}),
                             region = culler.cull(other, options_.cull);
    const culler::CullResult both = joined(culler.hierarchy(), own, region);
    const std::vector<bool> of_own = drawn_of(own, polygons), of_region = drawn_of(region, polygons),
                            drawn = drawn_of(both, polygons);
    std::size_t by_region = 0;
    for (std::uint32_t p = 0; p < polygons; ++p) ASSERT_EQ(drawn[p], of_own[p] && of_region[p]) << degrees << ' ' << p;
    for (const culler::Culled& culled : both.culled) {
      if (culled.by != culler::Culled::By::view) continue;
      ASSERT_LT(culled.index, both.view.size());
      ASSERT_GT(beyond_view(culler, both, culled), 0) << degrees << ' ' << culled.node;
      by_region += culled.index >= own.view.size();
    }
    EXPECT_GT(by_region, 0U) << degrees;
  }
}

TEST_P(HeldWalk, ARegionIsCulledWhenTheOneBeforeDoesNotHold) {
  const culler::Culler culler = make_culler(city_.soup, options_);
  FramesAlongPath along(culler, city_.path, options_);
  culler::View view;
  std::size_t before = 0;
  for (std::size_t frame = 0; frame < frames_; ++frame) {
    const culler::Camera camera = city_.path.camera(frame, aspect(options_));
    const bool holds = before > 0 && view.holds_for(camera);
    along.go_to(frame);
    along.cull();
    EXPECT_EQ(along.region(), holds ? before : before + 1) << frame;
    EXPECT_EQ(along.regions().size(), along.region());
    if (!holds) {
      const RegionRecord& region = along.regions().back();
      EXPECT_EQ(region.frame, frame);
      EXPECT_EQ(region.center, along.source().camera.eye);
      EXPECT_EQ(region.eyes, along.source().camera.eyes);
      // As far ahead as was asked, and to each side by a twentieth.
      EXPECT_NEAR(glm::length(region.eyes.half_edges[0]), options_.hold / 2, 1e-6);
      EXPECT_NEAR(glm::length(region.eyes.half_edges[1]), options_.hold / 20, 1e-6);
      EXPECT_NEAR(glm::length(region.eyes.half_edges[2]), options_.hold / 40, 1e-6);
      EXPECT_NEAR(glm::length(region.center - camera.eye), options_.hold / 2, 1e-6);
      culler.cull(along.source().camera, along.source().options, view);
    }
    before = along.region();
  }
  EXPECT_LT(along.regions().size(), frames_ / 2);
}

TEST_P(HeldWalk, IsTheSameEachTime) {
  const culler::Culler culler = make_culler(city_.soup, options_);
  FramesAlongPath one(culler, city_.path, options_), other(culler, city_.path, options_);
  for (std::size_t frame = 0; frame < frames_; frame += 7) {
    for (FramesAlongPath* const along : {&one, &other}) {
      along->go_to(frame);
      along->cull();
    }
    EXPECT_EQ(told(one.result()), told(other.result())) << frame;
  }
}

// Powers of two are exact.
TEST_P(HeldWalk, OfALargerModelIsTheSame) {
  options_.cull.method = culler::Method::cover;
  const auto larger = [](glm::dvec3& v) { v *= 4; };
  City city = city_;
  for (glm::dvec3& v : city.soup.vertices) larger(v);
  for (CameraPath::Keyframe& keyframe : city.path.keyframes) {
    larger(keyframe.eye);
    larger(keyframe.target);
  }
  city.path.near *= 4;
  WalkOptions options = options_;
  options.hold *= 4;
  const culler::Culler culler = make_culler(city_.soup, options_), of_larger = make_culler(city.soup, options);
  FramesAlongPath one(culler, city_.path, options_), other(of_larger, city.path, options);
  for (std::size_t frame = 0; frame < frames_; ++frame) {
    one.go_to(frame);
    other.go_to(frame);
    one.cull();
    other.cull();
    EXPECT_EQ(one.region(), other.region()) << frame;
  }
}

// Parallel rays turn by rounding when they move, unless they run along an axis.
TEST_P(HeldWalk, FramesForWhichNoRegionHoldsAreCulledForThemselves) {
  city_.path.projection = culler::Projection::orthographic;
  city_.path.height = 30;
  const culler::Culler culler = make_culler(city_.soup, options_);
  FramesAlongPath along(culler, city_.path, options_);
  culler::View view;
  std::size_t by_point = 0;
  for (std::size_t frame = 0; frame < 300; ++frame) {
    along.go_to(frame);
    along.cull();
    if (along.region() != 0) continue;
    ++by_point;
    const culler::Camera camera = city_.path.camera(frame, aspect(options_));
    EXPECT_TRUE(along.source().camera == camera);
    EXPECT_EQ(&along.source().result, &along.result());
    if (GetParam() == culler::Method::cover) {
      EXPECT_EQ(told(along.result()), told(culler.cull(camera, options_.cull, view))) << frame;
    }
  }
  EXPECT_GT(by_point, 0U);
}

TEST_P(HeldWalk, AnEyeThatStandsAndTurnsHasRegionsToo) {
  const CameraPath::Keyframe first = city_.path.keyframes.front();
  const double away = glm::length(first.target - first.eye);
  city_.path.keyframes.clear();
  for (const double degrees : {0.0, 40.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    city_.path.keyframes.push_back({first.eye, first.eye + away * glm::dvec3(std::cos(angle), std::sin(angle), 0)});
  }
  city_.path.frames = 81;  // half a degree each
  const culler::Culler culler = make_culler(city_.soup, options_);
  FramesAlongPath along(culler, city_.path, options_);
  for (std::size_t frame = 0; frame < city_.path.frames; ++frame) {
    along.go_to(frame);
    along.cull();
    EXPECT_GT(along.region(), 0U) << frame;
  }
  // Each for ten degrees.
  EXPECT_GE(along.regions().size(), 4U);
  EXPECT_LE(along.regions().size(), 6U);
}

TEST_P(HeldWalk, OrientedBoxesAreRefused) {
  options_.build.hierarchy.bounds = culler::Bounds::obb;
  EXPECT_THROW(static_cast<void>(make_culler(city_.soup, options_)), InputError);
}

INSTANTIATE_TEST_SUITE_P(Methods, HeldWalk, testing::Values(culler::Method::frusta, culler::Method::cover));

TEST(ViewPlanes, ThoseOfTheRegionFollow) {
  culler::Camera camera;
  EXPECT_EQ(name_of_plane(4, camera), "near");
  EXPECT_EQ(name_of_plane(5, camera), "region's left");
  camera.far_plane = 100;
  EXPECT_EQ(name_of_plane(5, camera), "far");
  EXPECT_EQ(name_of_plane(11, camera), "region's far");
}

}  // namespace held_walk_test
}  // namespace occlude::render
