// SPDX-License-Identifier: MIT
// A scene allocates nothing after its first frame. This is a separate executable, because it counts every allocation of the
// program.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "allocations.h"
#include "culler/scenes.h"
#include "occlude/culler/scene.h"

namespace {

using namespace occlude;
using namespace occlude::culler;

/// The box of object i. The objects are strewn over the town of random_town(), or all at one place if they are gathered.
/// `turn`, in radians, moves them around the middle and turns them.
kernel::Obb box(std::uint32_t i, double turn, bool is_gathered) {
  const double angle = 2.4 * i + turn, radius = is_gathered ? 0 : 2.0 * std::sqrt(i), c = std::cos(angle),
               s = std::sin(angle);
  return {{radius * c, radius * s, 1}, {{{c, s, 0}, {-s, c, 0}, {0, 0, 1}}}};
}

TEST(SceneAllocation, NoneAfterTheFirstFrame) {
  constexpr int kFrames = 200;
  std::vector<Box> boxes;
  for (std::uint32_t i = 0; i < 500; ++i) boxes.emplace_back(box(i, 0, false));
  Scene scene({.statics = boxes, .dynamics = boxes}, random_town(1, 1000));
  SceneView view;
  std::size_t hidden = 0, asked = 0;
  const auto walk = [&](int path, int frames) {
    for (int frame = 0; frame < frames; ++frame) {
      // Objects move at different speeds. Now and then all meet and scatter, so that trees are rebuilt.
      for (std::uint32_t i = 0; i < boxes.size(); ++i) scene.set_bounds(i, box(i, 0.01 * frame * (i % 7), frame % 50 == 0));
      scene.update();
      Camera camera;
      const double angle = 6.283185307179586 / kFrames * frame, radius = 30 + path;
      camera.eye = {radius * std::cos(angle), radius * std::sin(angle), 2};
      camera.target = {0, 0, 2};
      scene.cull(camera, {}, view);
      hidden += view.frame().stats.shadow_culled_polygons;
      for (const Box& b : boxes) asked += view.visibility(b) == Visibility::occluded;
    }
  };
  walk(0, 1);
  const std::size_t before = allocations();
  for (int path = 0; path < 3; ++path) walk(path, kFrames);
  EXPECT_EQ(allocations() - before, 0U);
  EXPECT_GT(hidden, 10000U);
  EXPECT_GT(asked, 10000U);
}

}  // namespace
