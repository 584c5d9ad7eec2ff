// SPDX-License-Identifier: MIT
// The scenes for regions of eyes reach what they aim at, and something is culled in them.
#include "differential/region_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

#include "cover/cover_buffer.h"
#include "model/bounds.h"
#include "occlude/culler/culler.h"

namespace occlude::fuzz {
namespace region_scenes_test {

using glm::dvec3;

/// The scenes of an aim among the first of seed 1.
std::vector<RegionScene> scenes_of(RegionAim aim) {
  std::vector<RegionScene> scenes;
  for (std::uint64_t seed = 1; seed <= 1200; ++seed) {
    Random random(seed);
    RegionScene scene = some_region_scene(random);
    if (scene.aim == aim) scenes.push_back(std::move(scene));
  }
  return scenes;
}

std::size_t count(RegionAim aim, const std::function<bool(const RegionScene&)>& reaches) {
  const std::vector<RegionScene> scenes = scenes_of(aim);
  EXPECT_GT(scenes.size(), 150U);
  return static_cast<std::size_t>(std::ranges::count_if(scenes, reaches));
}

/// The corners of polygon p. The first two polygons are the extent of the scene.
std::vector<dvec3> corners(const RegionScene& scene, std::size_t p) {
  std::vector<dvec3> corners;
  for (const std::uint32_t i : scene.soup.loop(p)) corners.push_back(scene.soup.vertices[i]);
  return corners;
}

dvec3 normal_of(const std::vector<dvec3>& loop) { return glm::cross(loop[1] - loop[0], loop[2] - loop[0]); }

double forward(const RegionScene& scene, const dvec3& v) {
  return glm::dot(v - scene.camera.eye, scene.camera.axes().forward);
}

/// Whether `depth` is within a share of one of the planes in focus, on this side of it.
bool is_at_focus(const RegionScene& scene, double depth, double share, double side) {
  return std::ranges::any_of(focus_distances(scene), [&](double focus) {
    return side * (depth - focus) >= 0 && side * (depth - focus) <= share * focus;
  });
}

TEST(RegionScenes, HaveEdgesWhoseEndsOvertakeEachOther) {
  const auto overtakes = [](const RegionScene& scene) {
    culler::CoverBuffer buffer;
    const double reach = std::ranges::max(scene.soup.vertices, {}, [&](const dvec3& v) { return glm::length(v); }).x;
    buffer.begin(culler::FrameView(scene.camera, std::fabs(reach)), scene.options.cover.width, scene.options.cover.height,
                 0);
    const culler::ConservativeViewport& picture = buffer.picture();
    for (std::size_t p = 2; p < scene.soup.size(); ++p) {
      const std::vector<dvec3> loop = corners(scene, p);
      const culler::EyePoint a = picture.eye_point(loop[1]), b = picture.eye_point(loop[2]);
      if (std::min(a.forward, b.forward) < picture.near()) continue;
      const culler::MovingPosition from = picture.moving(a), to = picture.moving(b);
      const culler::MovingEdge edge = picture.moving(from.still, to.still);
      // For what is infinitely far in focus.
      const auto at_from = edge.from.along.times(-1 / a.forward), at_to = edge.to.along.times(-1 / b.forward);
      const double past = std::max(at_from.low - (edge.length + at_to.low), at_from.high - (edge.length + at_to.high));
      if (edge.length < 4 && past > 1) return true;
    }
    return false;
  };
  EXPECT_GT(count(RegionAim::overtaking, overtakes), 60U);
}

TEST(RegionScenes, HaveEdgesThatTheLineOfTheEyesMeets) {
  std::size_t exactly = 0;
  const auto meets = [&](const RegionScene& scene) {
    const auto& way = scene.camera.eyes.half_edges[0];
    for (const auto& [from, to] : scene.edges) {
      const dvec3 a = from - scene.camera.eye, along = to - from, across = glm::cross(way, along);
      const double aside = glm::dot(across, a), size = glm::length(across) * glm::length(a);
      // (a + share along) x way = 0
      const double share = -glm::dot(glm::cross(a, way), glm::cross(along, way)) / glm::dot(across, across);
      if (std::fabs(aside) > 1e-12 * size || !(share > 0.01 && share < 0.99)) continue;
      exactly += aside == 0 ? 1 : 0;
      return true;
    }
    return false;
  };
  EXPECT_GT(count(RegionAim::epipole, meets), 100U);
  EXPECT_GT(exactly, 50U);
}

TEST(RegionScenes, HavePlanesThatTheEyesNearlyReach) {
  std::size_t nearly = 0, at_limit = 0, beyond = 0;
  const auto reaches = [&](const RegionScene& scene) {
    const std::vector<dvec3> wall = corners(scene, 2);
    const dvec3 normal = normal_of(wall);
    const double height = std::fabs(glm::dot(normal, wall[0] - scene.camera.eye));
    const double share = scene.camera.eyes.reach(normal) / height;
    nearly += share > 0.5 && share < 0.75 ? 1 : 0;
    at_limit += share >= 0.75 && share < 1 ? 1 : 0;
    beyond += share >= 1 ? 1 : 0;
    return true;
  };
  count(RegionAim::edge_on, reaches);
  EXPECT_GT(nearly, 20U);
  EXPECT_GT(at_limit, 20U);
  EXPECT_GT(beyond, 20U);
}

TEST(RegionScenes, HaveThingsJustBeforeAndBehindThePlanesInFocus) {
  for (const double side : {-1.0, 1.0}) {
    const auto has = [&](const RegionScene& scene) {
      for (std::size_t p = 2; p < scene.soup.size(); ++p) {
        if (is_at_focus(scene, forward(scene, corners(scene, p)[0]), 0x1p-20, side)) return true;
      }
      return false;
    };
    EXPECT_GT(count(RegionAim::layers, has), 120U);
  }
}

TEST(RegionScenes, HaveWallsThatTouchTheRegion) {
  std::size_t touching = 0, on_eye = 0;
  const auto touches = [&](const RegionScene& scene) {
    const std::vector<dvec3> wall = corners(scene, 2);
    const dvec3 normal = glm::normalize(normal_of(wall));
    const double height = std::fabs(glm::dot(normal, wall[0] - scene.camera.eye)), reach = scene.camera.eyes.reach(normal);
    touching += height == reach && reach > 0 ? 1 : 0;
    on_eye += height == 0 ? 1 : 0;
    return true;
  };
  count(RegionAim::touching, touches);
  EXPECT_GT(touching, 30U);
  EXPECT_GT(on_eye, 10U);
}

TEST(RegionScenes, HaveSliversInFocus) {
  const auto has = [](const RegionScene& scene) {
    for (std::size_t p = 2; p < scene.soup.size(); ++p) {
      const std::vector<dvec3> t = corners(scene, p);
      const double length = std::max({glm::length(t[1] - t[0]), glm::length(t[2] - t[1]), glm::length(t[0] - t[2])});
      if (!(glm::length(normal_of(t)) < 1e-3 * length * length)) continue;
      const auto is_in_focus = [&](const dvec3& v) {
        return is_at_focus(scene, forward(scene, v), 1e-6, 1) || is_at_focus(scene, forward(scene, v), 1e-6, -1);
      };
      if (std::ranges::all_of(t, is_in_focus)) return true;
    }
    return false;
  };
  EXPECT_GT(count(RegionAim::slivers, has), 60U);
}

TEST(RegionScenes, AreOfAllSizesAndHideSomething) {
  const culler::Checkpoint on_one_thread(culler::Executor::own_threads(1));
  for (const RegionAim aim : kRegionAims) {
    std::size_t small = 0, large = 0, hidden = 0;
    for (const RegionScene& scene : scenes_of(aim)) {
      small += scene.camera.near_plane < 0x1p-25 ? 1 : 0;
      large += scene.camera.near_plane > 0x1p25 ? 1 : 0;
      const culler::Culler culler(scene.soup, {.hierarchy = {.leaf_size = 1}, .occluders = {}, .lists = {.regions = 1}},
                                  on_one_thread);
      hidden += culler.cull(scene.camera, scene.options).stats.shadow_culled_polygons > 0 ? 1 : 0;
    }
    EXPECT_GT(small, 0U);
    EXPECT_GT(large, 0U);
    EXPECT_GT(hidden, 60U) << "aim " << static_cast<int>(aim);
  }
}

}  // namespace region_scenes_test
}  // namespace occlude::fuzz
