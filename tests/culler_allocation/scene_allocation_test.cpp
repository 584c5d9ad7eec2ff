// SPDX-License-Identifier: MIT
// A scene that has had its largest size allocates no more. This is a separate executable, because it counts every allocation
// of the program.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "allocations.h"
#include "culler/scenes.h"
#include "occlude/culler/scene.h"

namespace scene_allocation_test {

using namespace occlude;
using namespace occlude::culler;

/// The box of object i. The objects are strewn over the town of random_town(), or all at one place if they are gathered.
/// `turn`, in radians, moves them around the middle and turns them.
kernel::Obb box(std::uint32_t i, double turn, bool is_gathered) {
  const double angle = 2.4 * i + turn, radius = is_gathered ? 0 : 2.0 * std::sqrt(i), c = std::cos(angle),
               s = std::sin(angle);
  return {{radius * c, radius * s, 1}, {{{c, s, 0}, {-s, c, 0}, {0, 0, 1}}}};
}

/// Objects that move, tiles of objects and occluders that come and go, doors that open.
class World {
 public:
  World() {
    for (std::uint32_t i = 0; i < kMoving; ++i) moving_.push_back(scene_.add(box(i, 0, false), {.moves = true}));
    scene_.add(std::make_shared<OccluderMesh>(random_town(1, 1000)));
    for (int i = 0; i < 20; ++i) doors_.push_back(scene_.add(door_, {.origin = {2.0 * i, 3, 0}}, {.moves = true}));
  }

  void step(int frame) {
    // Objects move at different speeds. Now and then all meet and scatter.
    for (std::uint32_t i = 0; i < kMoving; ++i) {
      scene_.move(moving_[i], box(i, 0.01 * frame * (i % 7), frame % 50 == 0));
    }
    Tile& tile = tiles_[static_cast<std::size_t>(frame) % tiles_.size()];
    if (tile.is_in) {
      for (const ObjectId id : tile.objects) scene_.remove(id);
      scene_.remove(tile.occluder);
    } else {
      for (std::uint32_t i = 0; i < kOfTile; ++i) tile.boxes[i] = box(i + static_cast<std::uint32_t>(frame), 1, false);
      scene_.add(tile.boxes, {}, tile.objects);
      tile.occluder = scene_.add(door_, {.origin = {1.0 * frame, 0, 0}});
    }
    tile.is_in = !tile.is_in;
    for (std::size_t i = 0; i < doors_.size(); ++i) {
      if ((i + static_cast<std::size_t>(frame)) % 5 == 0) scene_.set_enabled(doors_[i], frame % 2 == 0);
    }
    scene_.set_enabled(moving_[static_cast<std::size_t>(frame) % kMoving], frame % 3 != 0);
    scene_.update();
  }

  [[nodiscard]] const Scene& scene() const { return scene_; }

 private:
  static constexpr std::uint32_t kMoving = 500, kOfTile = 200;
  struct Tile {
    bool is_in = false;
    std::array<Box, kOfTile> boxes;
    std::array<ObjectId, kOfTile> objects;
    OccluderId occluder;
  };

  Scene scene_;
  std::shared_ptr<const OccluderMesh> door_ = [] {
    PolygonSoup soup;
    soup.add_box({0, 0, 0}, {1, 0.1, 2});
    return std::make_shared<OccluderMesh>(soup);
  }();
  std::vector<ObjectId> moving_;
  std::vector<OccluderId> doors_;
  std::array<Tile, 7> tiles_;
};

TEST(SceneAllocation, NoneOnceItHasHadItsLargestSize) {
  constexpr int kFrames = 200;
  World world;
  SceneView view;
  std::size_t hidden = 0, asked = 0;
  int step = 0;
  const auto walk = [&](int path, int frames) {
    for (int frame = 0; frame < frames; ++frame) {
      world.step(step++);
      Camera camera;
      const double angle = 6.283185307179586 / kFrames * frame, radius = 30 + path;
      camera.eye = {radius * std::cos(angle), radius * std::sin(angle), 2};
      camera.target = {0, 0, 2};
      world.scene().cull(camera, {}, view);
      hidden += view.result().stats.hidden;
      for (std::uint32_t i = 0; i < 100; ++i) asked += view.visibility(box(i, 0, false)) == Visibility::occluded;
    }
  };
  walk(0, 60);  // each tile has come, and gone, and come again
  const std::size_t before = allocations();
  for (int path = 1; path < 4; ++path) walk(path, kFrames);
  EXPECT_EQ(allocations() - before, 0U);
  EXPECT_GT(hidden, 10000U);
  EXPECT_GT(asked, 1000U);
}

}  // namespace scene_allocation_test
