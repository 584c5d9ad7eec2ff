// SPDX-License-Identifier: MIT
// The preparation of a model can be stopped.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

#include "base/parallel.h"
#include "base/parallel_sort.h"
#include "executors.h"
#include "frame/culler_access.h"
#include "model/hierarchy_blocks.h"
#include "occlude/culler/culler.h"
#include "occlude/culler/executor.h"
#include "occlude/culler/occluder_mesh.h"
#include "occlude/kernel/validity.h"
#include "scenes.h"

namespace checkpoint_test {

namespace kernel = occlude::kernel;
using namespace occlude::culler;

/// Throws at its call number `last`, counted from 1.
struct Stop {
  std::size_t last;
  std::atomic<std::size_t> calls = 0;

  Checkpoint checkpoint() {
    return [this] {
      if (++calls == last) throw std::runtime_error("stopped");
    };
  }
};

constexpr std::size_t kNever = 0;

/// Expects that the preparation stops wherever the checkpoint throws.
template <class Prepare>
void expect_stops_anywhere(const Prepare& prepare) {
  Stop never{kNever};
  EXPECT_NO_THROW(prepare(never.checkpoint()));
  ASSERT_GT(never.calls, 100U);
  for (std::size_t last = 1; last <= never.calls; last += never.calls / 50) {
    Stop stop{last};
    EXPECT_THROW(prepare(stop.checkpoint()), std::runtime_error) << "at call " << last << " of " << never.calls;
  }
}

TEST(Checkpoint, StopsACuller) {
  const PolygonSoup soup = random_town_of_houses(3, 500);
  for (const Bounds bounds : {Bounds::aabb, Bounds::obb}) {
    const BuildConfig config{.hierarchy = {.bounds = bounds}, .lists = {.regions = 64}};
    expect_stops_anywhere([&](const Checkpoint& checkpoint) {
      const Culler culler(soup, config, checkpoint);
      culler.prepare(Method::cover, checkpoint);
      culler.prepare(Method::frusta, checkpoint);
    });
    expect_stops_anywhere([&](const Checkpoint& checkpoint) {
      static_cast<void>(preprocess(soup, config, {.viewpoints = 1}, {}, checkpoint));
    });
    const Parts parts = Culler(soup, config).parts();
    for (std::size_t last = 1; last <= 18; ++last) {
      Stop stop{last};
      EXPECT_THROW(Culler(parts, stop.checkpoint()), std::runtime_error) << last;
    }
  }
}

TEST(Checkpoint, StopsAnOccluderMesh) {
  const PolygonSoup soup = random_town_of_houses(3, 300);
  expect_stops_anywhere([&](const Checkpoint& checkpoint) { const OccluderMesh mesh(soup, checkpoint); });
}

/// A model is prepared on the threads that the caller gives, and is the same.
TEST(Checkpoint, SaysOnWhichThreads) {
  const PolygonSoup soup = random_town_of_houses(3, 6000);  // short work is not divided
  std::size_t parts = 0;
  const Executor mine(3, [&](std::size_t count, const Executor::Part& part) {
    for (std::size_t i = 0; i < count; ++i, ++parts) part(i);
  });
  const BuildConfig config{.lists = {.regions = 64}};
  const Culler culler(soup, config, Checkpoint(mine)), other(soup, config);
  for (const Method method : {Method::frusta, Method::cover}) {
    parts = 0;
    culler.prepare(method, Checkpoint(mine));
    EXPECT_GT(parts, 0U);
  }
  EXPECT_EQ(occluders_of(culler).lists().stored().first, occluders_of(other).lists().stored().first);
}

TEST(Checkpoint, AThreadThatRoundsOtherwiseDoesNothing) {
  const Executor upwards = rounding_upwards(3);
  std::vector<int> done(1000);
  const auto work = [&](std::size_t i) { done[i] += kernel::check_rounding() == kernel::Refusal::none ? 1 : 1000; };
  parallel_for(done.size(), work, Checkpoint(upwards));
  EXPECT_EQ(std::ranges::count(done, 1), 1000);
}

/// Neither the constructor nor the other method makes what a method alone needs, and it is made once. Both need the blocks
/// of the tree.
TEST(Checkpoint, IsCalledForWhatTheMethodNeedsAlone) {
  const PolygonSoup soup = random_town_of_houses(3, 300);
  const Culler culler(soup);
  const auto calls_of = [](const Culler& asked, Method method) {
    std::size_t calls = 0;
    asked.prepare(method, Checkpoint([&] { ++calls; }, Executor()));
    return calls;
  };
  std::size_t calls_of_blocks = 0;
  const Hierarchy tree = Hierarchy::build(soup, {});
  static_cast<void>(HierarchyBlocks(tree, Checkpoint([&] { ++calls_of_blocks; }, Executor())));
  View view;
  for (const Method method : {Method::cover, Method::frusta}) {
    const std::size_t calls = calls_of(culler, method);
    EXPECT_GT(calls, method == Method::cover ? 5U : 50U);
    EXPECT_EQ(calls + (method == Method::cover ? 0 : calls_of_blocks), calls_of(Culler(soup), method));
    EXPECT_EQ(calls_of(culler, method), 0U);
    CullOptions options{.method = Method::frusta};
    options.method = method;
    culler.cull(Camera{}, options, view);
    EXPECT_EQ(calls_of(culler, method), 0U);
  }
}

TEST(ParallelSort, IsStable) {
  std::mt19937 random(2);
  std::vector<std::uint32_t> order(500000), keys(order.size());
  std::iota(order.begin(), order.end(), 0U);
  for (std::uint32_t& key : keys) key = static_cast<std::uint32_t>(random()) % 1000;
  const auto less = [&](std::uint32_t a, std::uint32_t b) { return keys[a] < keys[b]; };
  std::vector<std::uint32_t> expected = order;
  std::stable_sort(expected.begin(), expected.end(), less);
  parallel_sort(order, {}, less);
  EXPECT_EQ(order, expected);
}

}  // namespace checkpoint_test
