// SPDX-License-Identifier: MIT
// A view that has been along a path before allocates nothing on it.
#include <gtest/gtest.h>

#include <cstddef>

#include "allocations.h"
#include "culler/scenes.h"
#include "occlude/culler/culler.h"
#include "occlude/culler/view.h"

namespace {

using namespace occlude::culler;

constexpr int kFrames = 100;

/// There and back through the middle of the town, by the houses and now and then into one.
Camera camera_at(int frame, Projection projection) {
  const int there = frame < kFrames / 2 ? frame : kFrames - frame;
  const double along = -45 + 90.0 * there / (kFrames / 2.0);
  Camera camera;
  camera.eye = {along, 0.2 * along, 2};
  camera.target = {along + 1, 0.2 * along + (frame % 40) * 0.05, 2};
  camera.projection = projection;
  camera.height = 20;
  return camera;
}

/// Allocations of one pass along the path.
std::size_t pass(const Culler& culler, const CullOptions& options, Projection projection, View& view) {
  const std::size_t before = allocations();
  for (int frame = 0; frame < kFrames; ++frame) culler.cull(camera_at(frame, projection), options, view);
  return allocations() - before;
}

TEST(View, AllocatesNothingOnAPathThatItKnows) {
  for (const Bounds bounds : {Bounds::aabb, Bounds::obb}) {
    const Culler culler(random_town_of_houses(31, 3000), {.hierarchy = {.leaf_size = 4, .bounds = bounds}});
    ASSERT_GT(culler.occluders().shells().size(), 50U);
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
      for (const bool is_papers : {false, true}) {
        CullOptions options;
        if (is_papers) options.near = occlude::kernel::Near::farthest;
        if (is_papers) options.test = occlude::kernel::Test::overlap;
        View view;
        EXPECT_GT(pass(culler, options, projection, view), 0U);
        for (int i = 0; i < 2; ++i) pass(culler, options, projection, view);
        EXPECT_EQ(pass(culler, options, projection, view), 0U);
        EXPECT_GT(view.result().stats.silhouette_faces, 0U) << "shells were among the occluders";
      }
    }
  }
}

TEST(View, AllocatesNothingByCoverEither) {
  const Culler culler(random_town_of_houses(31, 3000), {.hierarchy = {.leaf_size = 4}});
  View view;
  const CullOptions options{.method = Method::cover, .cover_width = 256, .cover_height = 144};
  EXPECT_GT(pass(culler, options, Projection::perspective, view), 0U);
  EXPECT_EQ(pass(culler, options, Projection::perspective, view), 0U);
  EXPECT_GT(view.result().stats.cover_groups, 0U);
}

}  // namespace
