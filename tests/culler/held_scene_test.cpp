// SPDX-License-Identifier: MIT
// Frames of scenes that are held against one that was culled before.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <glm/geometric.hpp>
#include <iostream>
#include <memory>
#include <random>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "frames.h"
#include "model/bounds.h"
#include "occlude/culler/held_cull.h"
#include "occlude/culler/scene.h"
#include "scenes.h"
#include "seed.h"
#include "seen_by_rays.h"
#include "wanderers.h"

namespace held_scene_test {

using namespace occlude::culler;
using glm::dvec3;
using occlude::seed_of;
using occlude::kernel::Aabb;

std::shared_ptr<const OccluderMesh> box_mesh(const Aabb& box) {
  PolygonSoup soup;
  soup.add_box({box.min.x, box.min.y, box.min.z}, {box.max.x, box.max.y, box.max.z});
  return std::make_shared<const OccluderMesh>(std::move(soup));
}

constexpr SceneOptions kHow{.cover = {.width = 192, .height = 128}};

/// Houses, vans and crowds, as they are in the scene and as the test knows them.
class Town {
 public:
  explicit Town(std::mt19937& random) : random_(random) {
    for (int k = 0; k < 60; ++k) add_house();
    for (int k = 0; k < 10; ++k) add_van();
    for (int k = 0; k < 300; ++k) add_thing();
    scene.update();
  }

  /// Something changes.
  void change() {
    for (Thing& thing : things_) {
      if (!thing.moves) continue;
      thing.box = moved(thing.box, {uniform(random_, -0.5, 0.5), uniform(random_, -0.5, 0.5), 0});
      scene.move(thing.id, thing.box);
    }
    for (House& van : vans_) {
      const dvec3 step{uniform(random_, -1, 1), uniform(random_, -1, 1), 0};
      van.box = moved(van.box, step);
      van.place += step;
      scene.move(van.occluder, {.origin = {van.place.x, van.place.y, 0}});
      scene.move(van.object, van.box);
    }
    if (random_() % 4 == 0) {
      const std::size_t i = random_() % things_.size();
      scene.remove(things_[i].id);
      things_.erase(things_.begin() + static_cast<std::ptrdiff_t>(i));
      add_thing();
    }
    if (random_() % 60 == 0) change_house();
    scene.update();
  }

  /// Expects that no object is left out of which a ray to a point of its box is free. Returns the number of rays.
  unsigned expect_hidden(const SceneResult& result, const Camera& camera) {
    const PolygonSoup soup = occluders();
    const Picture picture(camera);
    std::vector<ObjectId> drawn;
    for (const DrawnObject& object : result.drawn) drawn.push_back(object.id);
    std::ranges::sort(drawn);
    unsigned rays = 0;
    for (const Thing& thing : things_) {
      if (std::ranges::binary_search(drawn, thing.id)) continue;
      const auto& [low, high] = thing.box;
      const dvec3 point{uniform(random_, low.x, high.x), uniform(random_, low.y, high.y), uniform(random_, low.z, high.z)};
      if (!picture.shows(point)) continue;
      ++rays;
      EXPECT_FALSE(is_clear(soup, picture, point));
    }
    return rays;
  }

  Scene scene;

 private:
  struct Thing {
    ObjectId id;
    Aabb box;
    bool moves;
  };
  struct House {
    ObjectId object;
    OccluderId occluder;
    Aabb box;
    dvec3 place{0, 0, 0};
    bool is_shown = true;
  };

  static Aabb moved(const Aabb& box, const dvec3& step) {
    return {{box.min.x + step.x, box.min.y + step.y, box.min.z + step.z},
            {box.max.x + step.x, box.max.y + step.y, box.max.z + step.z}};
  }
  Aabb somewhere(double width, double height) {
    const double x = uniform(random_, -50, 50), y = uniform(random_, -50, 50);
    return {{x, y, 0}, {x + width, y + width, height}};
  }
  void add_house() {
    const double width = uniform(random_, 3, 12), height = uniform(random_, 3, 8);  // in the same order everywhere
    const Aabb box = somewhere(width, height);
    House house{scene.add(box), {}, box};
    house.occluder = scene.add(box_mesh(box), {}, {.object = random_() % 2 == 0 ? house.object : ObjectId{}});
    houses_.push_back(house);
  }
  void add_van() {
    const Aabb box = somewhere(3, 3);
    House van{scene.add(box, {.moves = true}), {}, box};
    van.occluder = scene.add(box_mesh(box), {}, {.moves = true, .object = van.object});
    vans_.push_back(van);
  }
  void add_thing() {
    const Aabb box = somewhere(0.5, 1);
    const bool moves = random_() % 3 == 0;
    things_.push_back({scene.add(box, {.moves = moves}), box, moves});
  }
  void change_house() {
    constexpr std::size_t kFewest = 30;  // a town in which houses come and go for long has some left
    if (houses_.size() < kFewest) return add_house();
    House& house = houses_[random_() % houses_.size()];
    switch (random_() % 5) {
      case 0:
        scene.remove(house.object);
        scene.remove(house.occluder);
        house = houses_.back();
        houses_.pop_back();
        break;
      case 1:
        add_house();
        break;
      case 2:
        house.is_shown = !house.is_shown;
        scene.set_enabled(house.object, house.is_shown);
        scene.set_enabled(house.occluder, house.is_shown);
        break;
      case 3:
        house.box = moved(house.box, {1, 0, 0});
        house.place.x += 1;
        scene.move(house.object, house.box);
        scene.move(house.occluder, {.origin = {house.place.x, 0, 0}});
        break;
      default:
        house.box = somewhere(2, 2);
        house.place = {0, 0, 0};
        scene.move(house.object, house.box);
        scene.replace(house.occluder, box_mesh(house.box));
        scene.move(house.occluder, {});
    }
  }
  [[nodiscard]] PolygonSoup occluders() const {
    PolygonSoup soup;
    for (const auto* group : {&houses_, &vans_}) {
      for (const House& house : *group) {
        if (house.is_shown) soup.add_box(to_glm(house.box.min), to_glm(house.box.max));
      }
    }
    return soup;
  }

  std::mt19937& random_;
  std::vector<Thing> things_;
  std::vector<House> houses_, vans_;
};

/// Answers are used for up to half a second, while everything changes.
TEST(HeldScenes, NothingThatIsSeenIsLeftOut) {
  std::mt19937 random(seed_of(5631));
  Town town(random);
  SceneOptions to_be_held = kHow;
  to_be_held.is_to_be_held = true;
  SceneView held, view;
  Camera region;
  unsigned of_held = 0, of_point = 0, rays = 0, hidden = 0;
  const unsigned frames = frames_wanted();
  for (unsigned frame = 0; frame < frames; ++frame) {
    if (frame % 30 == 0) {
      region = random_camera(random);
      region.projection = Projection::perspective;
      region.near_plane = 0.1;
      region.eyes = EyeRegion::ball(uniform(random, 0.1, 1));
      town.scene.cull(region, to_be_held, held);
    }
    town.change();
    Camera camera = region;
    const dvec3 moved = uniform(random, 0, region.eyes.radius) * glm::normalize(dvec3(1, uniform(random, -1, 1), 0.1));
    camera.eyes = {};
    camera.eye += moved;
    camera.target += moved;
    if (town.scene.holds(held, camera, kHow)) {
      ++of_held;
      const SceneResult& result = town.scene.cull(camera, kHow, held, view);
      hidden += static_cast<unsigned>(result.stats.hidden);
      EXPECT_LE(result.drawn.size() + result.stats.hidden + result.stats.out_of_view, town.scene.objects());
      rays += town.expect_hidden(result, camera);
    } else {
      ++of_point;
      rays += town.expect_hidden(town.scene.cull(camera, kHow, view), camera);
    }
    if (HasFailure()) FAIL() << "frame " << frame;
  }
  EXPECT_GT(of_held, frames / 4);
  EXPECT_GT(of_point, frames / 20);
  EXPECT_GT(hidden, frames);
  if (std::getenv("OCCLUDE_HELD_FRAMES") != nullptr) {
    std::cout << of_held << " frames held, " << of_point << " by point, " << rays << " rays, " << hidden << " hidden\n";
  }
}

/// A walk through a town that changes in each frame: nothing that is seen is left out. Returns the counts of its frames.
HeldStats walk(bool is_repeatable) {
  std::mt19937 random(seed_of(5632));
  Town town(random);
  Delays delays;
  HeldSceneCull held(town.scene,
                     {.later = delays.later([&] { return random() % 4 == 0 ? uniform(random, 0, 0.5) : 0.01; }),
                      .is_repeatable = is_repeatable},
                     kHow);
  Wanderer wanderer(random);
  unsigned rays = 0;
  const unsigned frames = frames_wanted();
  for (unsigned frame = 0; frame < frames && !testing::Test::HasFailure(); ++frame) {
    const double now = frame / 60.0;
    delays.pass_until(now);
    town.change();
    const Camera camera = wanderer.after(1 / 60.0);
    const SceneResult& result = frame % 7 == 3 ? held.cull(matrix_of(camera), now) : held.cull(camera, now);
    rays += town.expect_hidden(result, camera);
    if (testing::Test::HasFailure()) std::cout << "frame " << frame << "\n";
  }
  EXPECT_GT(rays, frames);
  const HeldStats& stats = held.stats();
  EXPECT_EQ(stats.frames, frames);
  if (std::getenv("OCCLUDE_HELD_FRAMES") != nullptr) {
    std::cout << stats.of_point << " frames by point, " << stats.regions << " regions, " << stats.late << " late, " << rays
              << " rays\n";
  }
  return stats;
}

/// With regions as HeldSceneCull wants them, and answers that come when they come.
TEST(HeldSceneCull, NothingThatIsSeenIsLeftOut) {
  const HeldStats stats = walk(false);
  EXPECT_LT(stats.of_point, stats.frames);
  EXPECT_GT(stats.regions, 0U);
}

/// How many frames are held depends on what regions cost, and so on the clock, but for results that can be repeated.
TEST(HeldSceneCull, FramesAreHeld) {
  const HeldStats stats = walk(true);
  EXPECT_LT(stats.of_point, stats.frames - stats.frames / 10);
  EXPECT_GT(stats.regions, stats.frames / 200);
}

/// On real threads, while the scene is updated.
TEST(HeldSceneCull, UpdatesWaitForRegions) {
  std::mt19937 random(seed_of(5633));
  Town town(random);
  std::vector<std::thread> threads;
  HeldSceneCull held(town.scene, {.later = [&](std::function<void()> task) { threads.emplace_back(std::move(task)); }},
                     kHow);
  unsigned held_frames = 0;
  for (unsigned frame = 0; frame < 200; ++frame) {
    town.change();
    Camera camera{.eye = {0.01 * frame, 0, 1.7}, .target = {1 + 0.01 * frame, 0, 1.7}, .near_plane = 0.05};
    town.expect_hidden(held.cull(camera, frame / 60.0), camera);
    held_frames += held.is_of_point() ? 0 : 1;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  EXPECT_GT(held_frames, 0U);
  for (std::thread& thread : threads) thread.join();
}

/// A wall that stands or moves, perhaps drawn by an object, and something behind it.
struct WallAndThing {
  Scene scene;
  ObjectId house = scene.add(Aabb{{10, -5, -5}, {11, 5, 5}}), thing = scene.add(Aabb{{20, -1, -1}, {21, 1, 1}});
  ObjectId beyond = scene.add(Aabb{{50, -1, -1}, {51, 1, 1}});
  OccluderId wall;
  SceneView held, view;
  Camera camera{.eye = {0, 0, 0}, .target = {1, 0, 0}};

  explicit WallAndThing(const OccluderOptions& options, bool is_drawn = false) {
    OccluderOptions of_wall = options;
    if (is_drawn) of_wall.object = house;
    wall = scene.add(box_mesh({{10, -5, -5}, {11, 5, 5}}), {}, of_wall);
    scene.update();
    cull_held();
  }
  void cull_held(SceneOptions options = kHow) {
    Camera region = camera;
    region.eyes = EyeRegion::ball(0.5);
    region.near_plane = 0.2;
    options.is_to_be_held = true;
    scene.cull(region, options, held);
  }
  bool holds(const SceneOptions& options = kHow) {
    scene.update();
    return scene.holds(held, camera, options);
  }
  std::size_t hidden() { return scene.cull(camera, kHow, held, view).stats.hidden; }
};

TEST(HeldScenes, WhatHappensToOccluders) {
  for (const bool is_drawn : {false, true}) {
    const auto changed = [&](const auto& change) {
      WallAndThing w({}, is_drawn);
      EXPECT_TRUE(w.holds());
      EXPECT_EQ(w.hidden(), 2U);
      change(w);
      return !w.holds();
    };
    EXPECT_TRUE(changed([](WallAndThing& w) { w.scene.remove(w.wall); }));
    EXPECT_TRUE(changed([](WallAndThing& w) { w.scene.remove(std::vector{w.wall}); }));
    EXPECT_TRUE(changed([](WallAndThing& w) { w.scene.move(w.wall, {.origin = {0, 1, 0}}); }));
    EXPECT_TRUE(changed([](WallAndThing& w) { w.scene.replace(w.wall, box_mesh({{10, 0, 0}, {11, 1, 1}})); }));
    EXPECT_TRUE(changed([](WallAndThing& w) { w.scene.set_enabled(w.wall, false); }));
    EXPECT_TRUE(changed([](WallAndThing& w) { w.scene.set_mask(w.wall, 1); }));
    EXPECT_EQ(changed([](WallAndThing& w) { w.scene.remove(w.house); }), is_drawn);
    EXPECT_EQ(changed([](WallAndThing& w) { w.scene.remove(std::vector{w.house}); }), is_drawn);
    EXPECT_EQ(changed([](WallAndThing& w) { w.scene.set_enabled(w.house, false); }), is_drawn);
    EXPECT_EQ(changed([](WallAndThing& w) { w.scene.set_mask(w.house, 1); }), is_drawn);
    EXPECT_FALSE(changed([](WallAndThing& w) { w.scene.add(box_mesh({{12, 0, 0}, {13, 1, 1}})); }));
    EXPECT_FALSE(changed([](WallAndThing& w) { w.scene.move(w.thing, Aabb{{20, 20, 0}, {21, 21, 1}}); }));
    EXPECT_TRUE(changed([](WallAndThing& w) {
      w.scene.move(w.thing, Aabb{{500, 20, 0}, {501, 21, 1}});
    })) << "farther than all was";
  }
}

TEST(HeldScenes, NoFrameIsHeldAgainstItsOwnView) {
  WallAndThing w({});
  EXPECT_THROW(w.scene.cull(w.camera, kHow, w.held, w.held), std::invalid_argument);
  EXPECT_EQ(w.hidden(), 2U) << "the view keeps its frame";
}

TEST(HeldScenes, WhatMovesHidesNothing) {
  WallAndThing w({.moves = true});
  EXPECT_TRUE(w.holds());
  EXPECT_EQ(w.hidden(), 0U);
  EXPECT_EQ(w.scene.cull(w.camera, kHow, w.view).stats.hidden, 2U);
  w.scene.move(w.wall, {.origin = {0, 1, 0}});
  EXPECT_TRUE(w.holds());
}

TEST(HeldScenes, ObjectsAreAskedWhereTheyAre) {
  WallAndThing w({});
  EXPECT_EQ(w.hidden(), 2U);
  w.scene.move(w.thing, Aabb{{20, 8, -1}, {21, 12, 1}});
  ASSERT_TRUE(w.holds());
  EXPECT_EQ(w.hidden(), 1U);
  const ObjectId added = w.scene.add(Aabb{{30, -1, -1}, {31, 1, 1}});
  ASSERT_TRUE(w.holds());
  EXPECT_EQ(w.hidden(), 2U);
  w.scene.set_enabled(added, false);
  ASSERT_TRUE(w.holds());
  EXPECT_EQ(w.hidden(), 1U);
}

TEST(HeldScenes, TellHowLargeObjectsLookFromTheirOwnCamera) {
  WallAndThing w({});
  SceneView own;
  w.camera.fov_y_deg = 40;
  ASSERT_TRUE(w.holds());
  const SceneResult& held = w.scene.cull(w.camera, kHow, w.held, w.view);
  const SceneResult& result = w.scene.cull(w.camera, kHow, own);
  ASSERT_EQ(held.drawn.size(), result.drawn.size());
  for (std::size_t i = 0; i < held.drawn.size(); ++i) {
    EXPECT_NEAR(held.drawn[i].size, result.drawn[i].size, 1e-3);
    EXPECT_NEAR(held.drawn[i].distance, result.drawn[i].distance, 1e-3);
  }
}

TEST(HeldScenes, OptionsMustBeThoseOfTheHeldFrame) {
  WallAndThing w({}, true);
  EXPECT_TRUE(w.holds());
  SceneOptions other = kHow;
  other.mask = 1;
  EXPECT_FALSE(w.holds(other));
  other = kHow;
  other.least_size = 0.1F;
  EXPECT_FALSE(w.holds(other));
  EXPECT_NE(refusal([&] { w.scene.cull(w.camera, other, w.held, w.view); }), "");
  w.cull_held(other);
  EXPECT_TRUE(w.holds(other)) << "the wall hides nothing, because its object may be too small";
  EXPECT_EQ(w.scene.cull(w.camera, other, w.held, w.view).stats.hidden, 0U);
  w.scene.cull(w.camera, kHow, w.held);
  EXPECT_FALSE(w.holds()) << "not to be held";
  Scene another;
  another.update();
  w.cull_held();
  EXPECT_FALSE(another.holds(w.held, w.camera, kHow));
  EXPECT_FALSE(w.scene.holds(w.view, w.camera, kHow));
}

}  // namespace held_scene_test
