// SPDX-License-Identifier: MIT
#include "frusta/occluder_choice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "frame/culler_access.h"
#include "frame/view_memory.h"
#include "frames.h"
#include "occlude/culler/culler.h"
#include "scenes.h"

namespace occluder_choice_test {

using namespace occlude::culler;

/// A wall that hides this many small walls, all of which are potential occluders.
PolygonSoup one_wall_before(std::size_t hidden) {
  PolygonSoup soup;
  add_wall(soup, 2, -2, 2, -2, 2);
  for (std::size_t i = 0; i < hidden; ++i) {
    const double x = 3 + 0.001 * static_cast<double>(i), y = -1 + 0.1 * static_cast<double>(i % 20);
    add_wall(soup, x, y, y + 0.05, 0, 0.05);
  }
  return soup;
}

/// A culler with the whole soup in one list.
Culler listing_all(const PolygonSoup& soup) { return Culler(soup, {.lists = {.threshold = 1e-12, .regions = 1}}); }

TEST(OccluderChoice, WorkIsBoundedWhereOneWallHidesAllOtherCandidates) {
  constexpr std::size_t kHidden = 20000;
  const Culler culler = listing_all(one_wall_before(kHidden));
  const CullOptions options{.method = Method::frusta, .occluders = 2};
  const CullResult frame = look(culler, options);
  ASSERT_EQ(frame.stats.occluders_in_view, kHidden + 1);
  EXPECT_EQ(frame.occluders.size(), 1U);
  EXPECT_EQ(frame.stats.shadow_culled_polygons, kHidden);
  const std::size_t most = kChoiceWorkOfEach * options.occluders;
  EXPECT_GE(frame.stats.choice_work, most) << "not all can be asked";
  EXPECT_LE(frame.stats.choice_work, most + PlaneWork::kExact + 100) << "no more than the last candidate beyond";
  EXPECT_EQ(look(culler, options).drawn, frame.drawn);
}

/// An occluder that the wall does not hide is chosen, however much the wall hides.
TEST(OccluderChoice, GoesOnBehindWhatAWallHides) {
  constexpr std::size_t kHidden = 5000;
  PolygonSoup soup = one_wall_before(kHidden);
  add_wall(soup, 60, 100, 100.01, 0, 0.01);  // the least of all, beside the wall
  const Culler culler = listing_all(soup);
  Camera camera;
  camera.fov_y_deg = 120;
  const CullResult frame = culler.cull(camera, {.method = Method::frusta, .occluders = 2});
  ASSERT_EQ(frame.occluders.size(), 2U);
  EXPECT_EQ(original(culler, frame.occluders[1]), kHidden + 1);
  EXPECT_LT(frame.stats.choice_work, 2 * kChoiceWorkOfEach);
}

/// The occluders of a region's list are gathered once, as long as the eye stays there. Without coherence a frame's choice
/// does not depend on the frames before.
TEST(OccluderChoice, IsOfTheRegionThatTheEyeIsIn) {
  const Culler culler(random_town_of_houses(7, 4000), {.lists = {.threshold = 1e-3, .regions = 256}});
  CullOptions options{.method = Method::frusta};
  options.objective.coherence = 0;
  View moving;
  const OccluderLists& lists = occluders_of(culler).lists();
  std::optional<std::size_t> region;
  std::size_t stays = 0, moves = 0;
  for (int frame = 0; frame < 120; ++frame) {
    Camera camera;
    camera.eye = {frame < 60 ? frame - 30 : 90 - frame, 3, 2};
    camera.target = camera.eye + glm::dvec3(1, 0.03 * frame - 2, 0);
    View fresh;
    const CullResult &here = culler.cull(camera, options, moving), &expected = culler.cull(camera, options, fresh);
    EXPECT_EQ(here.stats.occluders_in_view, expected.stats.occluders_in_view) << "frame " << frame;
    ASSERT_EQ(here.occluders.size(), expected.occluders.size()) << "frame " << frame;
    for (std::size_t i = 0; i < here.occluders.size(); ++i) {
      EXPECT_EQ(here.occluders[i].index, expected.occluders[i].index) << "frame " << frame;
    }
    const std::size_t now = lists.partition().region_at(camera.eye);
    if (region) ++(now == *region ? stays : moves);
    region = now;
  }
  EXPECT_GT(stays, 20U);
  EXPECT_GT(moves, 5U);
}

/// A wall that is seen edge-on casts no shadow, nor do the triangles that it consists of. No score tells the walls apart, so
/// they are tried in their order: one is the occluder, and the next two are seen edge-on.
TEST(OccluderChoice, WhatTheKernelRefusesIsNoProbeAndLeavesRoomForAnother) {
  PolygonSoup soup;
  add_wall(soup, 2, 5, 6, -1, 1);
  for (const double x : {4.0, 7.0}) {
    add(soup, {{x, 0, -1}, {x + 2, 0, -1}, {x + 2, 0, 1}});
    add(soup, {{x, 0, -1}, {x + 2, 0, 1}, {x, 0, 1}});
  }
  for (int i = 0; i < 8; ++i) add_wall(soup, 10 + i, 3 * i - 9, 3 * i - 7.5, -1, 1);
  const Culler culler = listing_all(soup);
  Camera camera;
  camera.target = {1, 0, 0};
  camera.fov_y_deg = 150;
  for (const std::size_t threads : {1U, 2U}) {
    const Executor executor = Executor::own_threads(threads);
    CullOptions options{.method = Method::frusta, .occluders = 1, .probes = 5, .executor = &executor};
    options.objective.solid_angle = 0;
    View view;
    const CullResult& frame = culler.cull(camera, options, view);
    ASSERT_EQ(frame.occluders.size(), 1U);
    EXPECT_EQ(original(culler, frame.occluders[0]), 0U);
    std::vector<std::uint32_t> probes;
    for (const Occluder& probe : memory_of(view).frusta.probes) {
      probes.push_back(original(culler, probe));
      EXPECT_EQ(memory_of(view).frusta.trials[probe.index], Trial::taken);
      EXPECT_GT(probe.frustum.plane_count(), 0U);
    }
    EXPECT_EQ(probes, (std::vector<std::uint32_t>{5, 6, 7, 8, 9}));
    std::size_t refused = 0;
    for (const std::uint32_t i : memory_of(view).frusta.tried)
      refused += memory_of(view).frusta.trials[i] == Trial::refused ? 1 : 0;
    EXPECT_EQ(refused, 6U) << "two walls and their triangles";
    EXPECT_GE(frame.stats.choice_work, refused * PlaneWork::kExact);
  }
}

/// Scores that are NaN could not be sorted.
TEST(OccluderChoice, IsMadeWhateverTheWeights) {
  const double infinity = std::numeric_limits<double>::infinity();
  PolygonSoup soup;
  for (int i = 0; i < 100; ++i) add_wall(soup, 20 + i, i % 10 - 5, i % 10 - 4.5, -1, 0.1 * (i % 7));
  const Culler culler = listing_all(soup);
  for (const double weight : {std::nan(""), infinity, -infinity, 1e300, -1e300, 0.5}) {
    const CullOptions options{.method = Method::frusta,
                              .objective = {.solid_angle = weight, .depth_complexity = weight, .coherence = weight}};
    View view;
    for (int frame = 0; frame < 3; ++frame) {
      const CullResult& result = culler.cull(Camera{}, options, view);
      EXPECT_GT(result.occluders.size(), 0U) << weight;
      ASSERT_GT(memory_of(view).frusta.candidates.size(), 50U);
      for (const Candidate& candidate : memory_of(view).frusta.candidates)
        EXPECT_TRUE(std::isfinite(candidate.score)) << weight;
    }
  }
}

}  // namespace occluder_choice_test
