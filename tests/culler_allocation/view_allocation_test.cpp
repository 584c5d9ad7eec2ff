// SPDX-License-Identifier: MIT
// A view allocates only in its first frame, wherever it goes then.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>

#include "allocations.h"
#include "culler/scenes.h"
#include "frame/culler_access.h"
#include "occlude/culler/culler.h"

namespace view_allocation_test {

using namespace occlude::culler;

constexpr int kFrames = 100;

/// Goes there and back through the middle of the town, past the houses and now and then into one. Each path has another
/// direction.
Camera camera_at(int path, int frame, Projection projection) {
  const int there = frame < kFrames / 2 ? frame : kFrames - frame;
  const double along = -45 + 90.0 * there / (kFrames / 2.0), across = 0.2 * along + (frame % 40) * 0.05;
  const double c = std::cos(path), s = std::sin(path);
  Camera camera;
  camera.eye = {c * along - s * 0.2 * along, s * along + c * 0.2 * along, 2};
  camera.target = {c * (along + 1) - s * across, s * (along + 1) + c * across, 2};
  camera.projection = projection;
  camera.height = 20;
  return camera;
}

/// The number of allocations in frames [begin, end) of a path.
std::size_t walk(const Culler& culler, const CullOptions& options, Projection projection, View& view, int path,
                 int begin = 0, int end = kFrames) {
  const std::size_t before = allocations();
  for (int frame = begin; frame < end; ++frame) culler.cull(camera_at(path, frame, projection), options, view);
  return allocations() - before;
}

TEST(View, AllocatesInItsFirstFrameAlone) {
  for (const Bounds bounds : {Bounds::aabb, Bounds::obb}) {
    const Culler culler(random_town_of_houses(31, 3000), {.hierarchy = {.leaf_size = 4, .bounds = bounds}});
    ASSERT_GT(occluders_of(culler).shells().size(), 50U);
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
      for (const bool is_papers : {false, true}) {
        CullOptions options{.method = Method::frusta};
        if (is_papers) options.shadow_near = occlude::kernel::Near::farthest;
        if (is_papers) options.test = occlude::kernel::Test::overlap;
        if (is_papers) options.margin = 0.001;
        View view;
        EXPECT_GT(walk(culler, options, projection, view, 0, 0, 1), 0U);
        for (int path = 0; path < 4; ++path) EXPECT_EQ(walk(culler, options, projection, view, path), 0U) << path;
        EXPECT_GT(view.result().stats.silhouette_faces, 0U) << "shells were among the occluders";
      }
    }
  }
}

TEST(View, AllocatesNothingByCoverEither) {
  const Culler culler(random_town_of_houses(31, 3000), {.hierarchy = {.leaf_size = 4}});
  for (const std::size_t work : {std::numeric_limits<std::size_t>::max(), std::size_t{3000}}) {
    View view;
    CullOptions options{.method = Method::cover, .cover = {.width = 256, .height = 144}};
    options.cover.work = work;
    EXPECT_GT(walk(culler, options, Projection::perspective, view, 0, 0, 1), 0U);
    for (int path = 0; path < 4; ++path) EXPECT_EQ(walk(culler, options, Projection::perspective, view, path), 0U) << path;
    EXPECT_TRUE(work == 3000 || view.result().stats.cover_groups > 0);
    EXPECT_EQ(view.result().stats.cover_work.asking > 0, work == 3000) << "what was left was asked";
  }
}

/// With an executor, not when the paths are walked again and again. A frame divides subtrees by what earlier frames found,
/// so from some time on they are the same each time.
TEST(View, AllocatesNothingForSubtreesAsManyAsBefore) {
  const Culler culler(random_town_of_houses(31, 3000), {.hierarchy = {.leaf_size = 4}});
  const auto one_after_another = [](std::size_t count, const Executor::Part& part) {
    for (std::size_t i = 0; i < count; ++i) part(i);
  };
  const Executor executor(2, one_after_another);
  View view;
  CullOptions options{.method = Method::frusta};
  options.executor = &executor;
  std::size_t first = 0;
  for (int path = 0; path < 8; ++path) first += walk(culler, options, Projection::perspective, view, path % 4);
  EXPECT_GT(first, 0U);
  for (int path = 0; path < 4; ++path) EXPECT_EQ(walk(culler, options, Projection::perspective, view, path), 0U) << path;
}

}  // namespace view_allocation_test
