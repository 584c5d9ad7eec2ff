// SPDX-License-Identifier: MIT
// Culls that hold for the frames between them.
#include "occlude/culler/held_cull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <iostream>
#include <limits>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "frames.h"
#include "held/background.h"
#include "held/held_region.h"
#include "held/lease.h"
#include "held/motion.h"
#include "scenes.h"
#include "seed.h"
#include "seen_by_rays.h"
#include "wanderers.h"

namespace held_cull_test {

using namespace occlude::culler;
using glm::dvec3;
using occlude::seed_of;

std::vector<bool> drawn_polygons(const Culler& culler, const HeldResult& result) {
  CullResult frame;
  frame.drawn = result.drawn;
  return drawn_polygons(culler, frame);
}

constexpr CoverOptions kCover{.width = 256, .height = 144};
constexpr CullOptions kHow{.method = Method::cover, .cover = kCover};

/// Rows of houses of different heights along streets, without gaps but for some, with small things in the streets.
PolygonSoup streets(std::mt19937& random) {
  PolygonSoup soup;
  for (double y = -50; y <= 50; y += 20) {
    for (double x = -50; x < 50; x += 10) {
      if (random() % 8 == 0) continue;
      const double height = uniform(random, 4, 12);
      add_box(soup, {x, y - 5, 0}, {x + 10, y + 5, height}, random() % 2 == 0);
    }
  }
  while (soup.size() < 1200) {
    const dvec3 at{uniform(random, -55, 55), uniform(random, -60, 60), uniform(random, 0, 3)};
    const auto near = [&] { return at + dvec3{uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -0.5, 0.5)}; };
    add(soup, {near(), near(), near()});
  }
  return soup;
}

/// Answers come after up to half a second, or never in time.
TEST(HeldCull, NothingThatIsSeenIsEverLeftOut) {
  std::mt19937 random(seed_of(5621));
  const Culler culler(streets(random), {.hierarchy = {.leaf_size = 4}});
  Delays delays;
  HeldCull held(culler, {.later = delays.later([&] { return random() % 4 == 0 ? uniform(random, 0, 0.5) : 0.01; })}, kHow);
  Wanderer wanderer(random);
  unsigned rays = 0;
  const unsigned frames = frames_wanted();
  for (unsigned frame = 0; frame < frames; ++frame) {
    const double now = frame / 60.0;
    delays.pass_until(now);
    const Camera camera = wanderer.after(1 / 60.0);
    const HeldResult& result = frame % 7 == 3 ? held.cull(matrix_of(camera), now) : held.cull(camera, now);
    rays += expect_hidden(culler, drawn_polygons(culler, result), camera, random, 20);
    if (HasFailure()) FAIL() << "frame " << frame;
  }
  const HeldStats& stats = held.stats();
  EXPECT_EQ(stats.frames, frames);
  EXPECT_GT(rays, frames);
  EXPECT_LT(stats.of_point, frames - frames / 10);
  EXPECT_GT(stats.regions, frames / 200);
  EXPECT_GT(stats.around, 0U);
  EXPECT_GT(stats.late, 0U);
  if (std::getenv("OCCLUDE_HELD_FRAMES") != nullptr) {
    std::cout << stats.of_point << " frames by point, " << stats.regions << " regions, " << stats.around << " around, "
              << stats.late << " late, " << rays << " rays\n";
  }
}

/// How many frames of a walk are by point.
HeldStats walk(const Culler& culler, HeldOptions options, double speed, double turning, unsigned frames) {
  HeldCull held(culler, std::move(options), kHow);
  for (unsigned frame = 0; frame < frames; ++frame) {
    const double now = frame / 60.0, angle = glm::radians(turning) * now;
    Camera camera{.eye = {-40, 1, 1.7}, .near_plane = 0.05};
    camera.eye.x += speed * now;
    camera.target = camera.eye + dvec3(std::cos(angle), std::sin(angle), 0);
    static_cast<void>(held.cull(camera, now));
  }
  return held.stats();
}

const Culler& town() {
  static const Culler culler(random_town_of_houses(57, 3000), {.hierarchy = {.leaf_size = 4}});
  return culler;
}

Later at_once() {
  return [](const std::function<void()>& task) { task(); };
}

TEST(HeldCull, RegionsHoldForManyFrames) {
  const HeldStats walking = walk(town(), {.later = at_once()}, 1.5, 0, 600);
  EXPECT_LE(walking.of_point, 5U);
  EXPECT_LE(walking.regions, 20U);
  const HeldStats turning = walk(town(), {.later = at_once()}, 0, 180, 600);
  EXPECT_LE(turning.of_point, 20U);
  EXPECT_LE(turning.regions, 20U);
  EXPECT_GT(turning.around, 0U);
}

TEST(HeldCull, WithoutAnotherThreadRegionsAreCulledWhenTheyAreNeeded) {
  const HeldStats walking = walk(town(), {}, 1.5, 0, 600);
  EXPECT_EQ(walking.of_point, 0U);
  EXPECT_LE(walking.regions, 40U);
}

TEST(HeldCull, RepeatableResultsDependOnNoThread) {
  const auto run = [&](Later later, HeldStats& stats) {
    HeldCull held(town(), {.later = std::move(later), .is_repeatable = true}, kHow);
    std::mt19937 random(5);
    Wanderer wanderer(random);
    std::vector<std::size_t> drawn;
    for (unsigned frame = 0; frame < 400; ++frame) {
      drawn.push_back(held.cull(wanderer.after(1 / 60.0), frame / 60.0).drawn_polygons);
    }
    stats = held.stats();
    return drawn;
  };
  std::vector<std::thread> threads;
  HeldStats stats, again;
  const auto expected = run(at_once(), stats);
  EXPECT_GT(stats.regions, 3U);
  EXPECT_LT(stats.of_point, 200U);
  EXPECT_EQ(run([](const std::function<void()>&) {}, again), expected) << "never run by the caller";
  EXPECT_EQ(again.of_point, stats.of_point);
  EXPECT_EQ(run([&](std::function<void()> task) { threads.emplace_back(std::move(task)); }, again), expected);
  for (std::thread& thread : threads) thread.join();
}

TEST(HeldCull, ItsThreadsTouchNothingThatIsGone) {
  std::vector<std::thread> threads;
  std::vector<std::function<void()>> left;
  {
    HeldCull moved_to = [&] {
      HeldCull held(town(), {.later = [&](std::function<void()> task) { threads.emplace_back(std::move(task)); }});
      static_cast<void>(held.cull(Camera{.eye = {0, 0, 2}, .target = {1, 0, 2}}, 0));
      return held;
    }();
    static_cast<void>(moved_to.cull(Camera{.eye = {0, 0, 2}, .target = {1, 0, 2}}, 1));
    HeldCull waits(town(), {.later = [&](std::function<void()> task) { left.push_back(std::move(task)); }});
    static_cast<void>(waits.cull(Camera{.eye = {0, 0, 2}, .target = {1, 0, 2}}, 0));
  }
  for (std::thread& thread : threads) thread.join();
  ASSERT_EQ(left.size(), 1U);
  left[0]();  // does nothing
}

/// An executor may be able to do one thing at a time alone, and frames go on while regions are culled.
TEST(HeldCull, ItsExecutorDoesFramesAlone) {
  std::atomic<unsigned> by_caller = 0, by_others = 0;
  const auto run = [&, caller = std::this_thread::get_id()](std::size_t count, const Executor::Part& part) {
    ++(std::this_thread::get_id() == caller ? by_caller : by_others);
    for (std::size_t i = 0; i < count; ++i) part(i);
  };
  const Executor executor(2, run);
  std::vector<std::thread> threads;
  HeldStats stats;
  {
    HeldCull held(town(), {.later = [&](std::function<void()> task) { threads.emplace_back(std::move(task)); }},
                  {.method = Method::frusta, .executor = &executor});
    for (int frame = 0; frame < 20; ++frame) {
      static_cast<void>(held.cull(Camera{.eye = {2.0 * frame, 0, 2}, .target = {100, 0, 2}}, frame));
      for (std::thread& thread : threads) thread.join();
      threads.clear();
    }
    stats = held.stats();
  }
  EXPECT_GT(stats.regions, 0U);
  EXPECT_GT(by_caller, 0U);
  EXPECT_EQ(by_others, 0U);
}

TEST(HeldCull, WhatIsThrown) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  HeldCull held(town(), {.later = [](const std::function<void()>&) { throw std::runtime_error("no thread"); }});
  EXPECT_THROW(static_cast<void>(held.cull(Camera{}, 0)), std::runtime_error);
  EXPECT_NE(refusal([&] { static_cast<void>(held.cull(Camera{.near_plane = -1}, 1)); }), "");
  EXPECT_EQ(refusal([&] { static_cast<void>(held.cull(Camera{}, kNaN)); }), "the time of the frame is not finite");
  EXPECT_EQ(refusal([&] { const HeldCull turns(town(), {.way = {.turn_degrees = -1}}); }),
            "the way ahead: the camera must turn by 0 degrees or more");
  EXPECT_NE(refusal([&] { const HeldCull nowhere(town(), {.way = {.aside = kNaN}}); }), "");
}

TEST(HeldCull, ParallelRaysAreCulledByPoint) {
  HeldCull held(town(), {.later = at_once()});
  const Camera parallel{.eye = {0, 0, 2}, .target = {1, 0, 2}, .projection = Projection::orthographic, .height = 20};
  for (int frame = 0; frame < 5; ++frame) {
    EXPECT_TRUE(held.cull(parallel, frame).is_of_point);
    EXPECT_TRUE(held.cull(matrix_of(parallel), frame).is_of_point);
  }
  EXPECT_EQ(held.stats().regions, 0U);
}

/// Six pictures hold for whatever direction, near planes that reach anywhere included.
TEST(HeldRegions, AllAround) {
  std::mt19937 random(seed_of(5622));
  Camera camera{.eye = {0, 0, 2}, .target = {1, 0, 2}, .fov_y_deg = 70, .near_plane = 0.1};
  const double depth = 200;
  const Camera ahead_of = ahead(camera, {1, 0, 0}, 1);
  const auto cameras = all_around(ahead_of, *near_around(camera, depth) * (1 + 1.0 / 64));
  HeldRegion region;
  View view;
  EXPECT_FALSE(region.holds_for(camera));
  region.cull(town(), cameras, kHow, view);
  for (int k = 0; k < 1000; ++k) {
    camera.eye = dvec3(uniform(random, 0.001, 0.999), uniform(random, -0.09, 0.09), uniform(random, 1.96, 2.04));
    const auto [x, y, z] = random_vector(random, -1, 1);
    if (std::fabs(x) + std::fabs(y) < 0.1) continue;
    camera.target = camera.eye + dvec3{x, y, z};
    ASSERT_TRUE(region.holds_for(camera)) << k;
    ASSERT_TRUE(region.holds_for(matrix_of(camera))) << k;
    Camera beside = camera;
    beside.eye.y += 0.2;
    ASSERT_FALSE(region.holds_for(beside)) << k;
    Camera clips = camera;
    clips.near_plane = 0.11;
    ASSERT_FALSE(region.holds_for(clips)) << k;
  }
}

/// No point of a near plane is farther.
TEST(HeldRegions, NearPlanesFromAnyDirection) {
  std::mt19937 random(seed_of(5623));
  for (int k = 0; k < 1000; ++k) {
    Camera camera = random_camera(random);
    camera.projection = Projection::perspective;
    camera.fov_y_deg = uniform(random, 10, 150);
    const auto near = near_around(camera, 10), of_matrix = near_around(matrix_of(camera), 10);
    ASSERT_TRUE(near && of_matrix);
    const Picture picture(camera);
    const Vector corner = picture.corner(3, picture.near);
    ASSERT_GE(*near, std::sqrt(dot(corner, corner)));
    ASSERT_GE(*of_matrix, std::sqrt(dot(corner, corner)));
    ASSERT_LE(*near, 1.001L * std::sqrt(dot(corner, corner)));
  }
  EXPECT_FALSE(near_around(Camera{.projection = Projection::orthographic}, 10));
}

TEST(Motions, JumpsCountForNothing) {
  Motion motion;
  motion.see({0, 0, 0}, {1, 0, 0}, 0);
  EXPECT_EQ(glm::length(motion.velocity()), 0);
  for (int frame = 1; frame <= 3; ++frame) motion.see({0.5 * frame, 0, 0}, {1, 0, 0}, 0.5 * frame);
  EXPECT_EQ(motion.velocity(), dvec3(1, 0, 0));
  motion.see({100, 0, 0}, {0, 1, 0}, 2);
  EXPECT_EQ(motion.velocity(), dvec3(1, 0, 0));
  EXPECT_EQ(motion.turning(), 0);
  motion.see({100.5, 0, 0}, {0, 1, 0}, 2.5);
  EXPECT_EQ(motion.velocity(), dvec3(1, 0, 0));
  motion.see({100.5, 0, 0}, {0, 1, 0}, 2.5);
  EXPECT_EQ(motion.frame_seconds(), 0.5) << "no time has gone";
}

TEST(Leases, GrowShrinkAndRest) {
  Lease lease;
  const auto seconds = [&] { return lease.seconds(false, 0); };
  const double usual = seconds();
  lease.hid(1, 0);
  EXPECT_EQ(seconds(), 2 * usual);
  EXPECT_TRUE(lease.has_changed());
  lease.hid(0.95, 0);
  EXPECT_EQ(seconds(), 2 * usual);
  EXPECT_FALSE(lease.has_changed());
  lease.hid(0.7, 0);
  EXPECT_EQ(seconds(), usual);
  lease.held(0.9 * usual, usual, false, 100, 0);
  EXPECT_EQ(seconds(), usual);
  lease.held(0.1 * usual, usual, false, 100, 0);
  EXPECT_LT(seconds(), usual);
  for (int k = 0; k < 10 && lease.pays(0); ++k) lease.hid(0.1, 0);
  EXPECT_FALSE(lease.pays(0.12));
  EXPECT_TRUE(lease.pays(0.125));
  lease.hid(0.1, 1);
  EXPECT_FALSE(lease.pays(1.24)) << "it rests for longer";
  EXPECT_TRUE(lease.pays(1.25));
}

TEST(Leases, RestAfterRegionsThatHardlyAnythingUsed) {
  Lease lease;
  lease.held(1, 1, false, 3, 0);
  EXPECT_TRUE(lease.pays(0)) << "once";
  lease.held(1, 1, false, 4, 0);
  lease.held(1, 1, true, 15, 0);
  EXPECT_TRUE(lease.pays(0)) << "once more";
  lease.held(1, 1, true, 15, 0);
  EXPECT_FALSE(lease.pays(0.12));
  EXPECT_TRUE(lease.pays(0.125));
}

TEST(Leases, AreNoShorterThanTheirTime) {
  Lease lease;
  lease.cost(false, 30);
  lease.cost(true, 120);
  EXPECT_EQ(lease.seconds(false, 1), 60);
  EXPECT_EQ(lease.seconds(true, 1), 240);
}

}  // namespace held_cull_test
