// SPDX-License-Identifier: MIT
#include "occlude/culler/occluder_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "occlude/culler/hierarchy.h"
#include "scenes.h"

namespace {

using namespace occlude::culler;

struct Model {
  explicit Model(const PolygonSoup& soup)
      : box(Hierarchy::build(soup, {}).nodes()[0].box),
        occluders(PotentialOccluders::find(std::make_shared<const PolygonSoup>(soup), {})) {}

  [[nodiscard]] OccluderGrid grid(const OccluderGrid::Config& config = {}) const {
    return OccluderGrid::build(occluders, box, config);
  }

  occlude::kernel::Aabb box;
  PotentialOccluders occluders;
};

TEST(AreaAngle, IsAreaTimesCosineOverSquaredDistance) {
  const PotentialOccluder wall{.centre = {10, 0, 0}, .area_normal = {4, 0, 0}};
  EXPECT_DOUBLE_EQ(wall.area_angle({0, 0, 0}), 0.04);
  EXPECT_DOUBLE_EQ(wall.area_angle({20, 0, 0}), 0.04);  // hides from both sides
  EXPECT_DOUBLE_EQ(wall.area_angle({10, 5, 0}), 0);     // edge-on
  EXPECT_DOUBLE_EQ(wall.area_angle({0, 10, 0}), 4 * std::sqrt(0.5) / 200);
  EXPECT_EQ(wall.area_angle({10, 0, 0}), 0);
}

TEST(OccluderGrid, ListsEveryOccluderAboveTheThreshold) {
  const PolygonSoup soup = random_town(11, 2000);
  const Model model(soup);
  const OccluderGrid::Config config{.threshold = 0.05, .regions = 4096};
  const OccluderGrid grid = model.grid(config);
  std::mt19937 random(5);
  std::size_t above = 0, listed = 0;
  for (int i = 0; i < 300; ++i) {
    const glm::dvec3 eye{uniform(random, -50, 50), uniform(random, -50, 50), uniform(random, 0, 6)};
    const auto list = grid.list(eye).occluders;
    listed += list.size();
    for (std::uint32_t p = 0; p < model.occluders.size(); ++p) {
      if (model.occluders[p].area_angle(eye) < config.threshold) continue;
      ++above;
      ASSERT_NE(std::find(list.begin(), list.end(), p), list.end());
    }
  }
  EXPECT_GT(above, 300U);
  EXPECT_LT(listed, 300 * soup.size() / 4);  // and it does leave most out
}

TEST(OccluderGrid, PointsOutsideTheModelGoToTheNearestRegion) {
  const PolygonSoup soup = random_town(3, 500);
  const OccluderGrid grid = Model(soup).grid();
  EXPECT_EQ(grid.region_at({1e9, -1e9, 1e9}), grid.region_at({1e12, -1e12, 1e12}));
}

TEST(OccluderGrid, FlatAndDegenerateModels) {
  PolygonSoup flat;
  add_wall(flat, 1, 0, 1, 0, 1);
  EXPECT_EQ(Model(flat).grid().list({1, 0.5, 0.5}).occluders.size(), 1U);
  PolygonSoup point;
  add(point, {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}});
  EXPECT_EQ(Model(point).grid().lists().occluders.size(), 0U);
}

/// Random triangles, each as large as the model.
PolygonSoup large_triangles(std::size_t count) {
  std::mt19937 random(17);
  const auto corner = [&] {
    return glm::dvec3{uniform(random, -10, 10), uniform(random, -10, 10), uniform(random, -10, 10)};
  };
  PolygonSoup soup;
  while (soup.size() < count) add(soup, {corner(), corner(), corner()});
  return soup;
}

TEST(OccluderGrid, KeepsToItsBudgetLargestFirst) {
  const Model model(large_triangles(500));
  const OccluderGrid all = model.grid({.regions = 512});
  constexpr std::size_t kEntries = 20000;
  const OccluderGrid some = model.grid({.regions = 512, .entries = kEntries});
  ASSERT_GT(all.lists().occluders.size(), 3 * kEntries);
  EXPECT_LE(some.lists().occluders.size(), kEntries);
  EXPECT_GT(some.lists().occluders.size(), kEntries * 9 / 10);
  std::size_t largest_listed = 0, listed = 0;
  for (std::size_t region = 0; region < some.regions(); ++region) {
    const auto before = all.list(region).occluders, kept = some.list(region).occluders;
    EXPECT_TRUE(std::ranges::includes(before, kept));
    EXPECT_GT(kept.size(), 20U) << "no list is cut more than others";
    if (before.empty()) continue;
    const glm::dvec3 middle = some.corner(region) + some.edge() / 2;
    const auto looks = [&](std::uint32_t i) { return model.occluders[i].area_angle(middle); };
    const auto largest = *std::ranges::max_element(before, {}, looks);
    if (!kept.empty()) ++listed;
    if (std::ranges::binary_search(kept, largest)) ++largest_listed;
  }
  EXPECT_GT(largest_listed, listed * 9 / 10) << "by what looks largest from somewhere in the region, not from its middle";
}

TEST(OccluderGrid, OfABudgetThatIsNotSpentNothingIsCut) {
  const Model model(random_town_of_houses(4, 1500));
  constexpr double kThreshold = 0.1;  // with a lower one, so small a model spends its budget
  const OccluderGrid grid = model.grid({.threshold = kThreshold});
  const std::size_t entries = grid.lists().occluders.size();
  ASSERT_LT(entries, OccluderGrid::Config::kEntriesOfFew);
  EXPECT_EQ(model.grid({.threshold = kThreshold, .entries = entries}).lists().occluders, grid.lists().occluders);
  EXPECT_LT(model.grid({.threshold = kThreshold, .entries = entries - 1}).lists().occluders.size(), entries);
}

TEST(OccluderGrid, OfASmallModelItsBudgetIsSmall) {
  using Config = OccluderGrid::Config;
  const Model few(large_triangles(2000)), more(large_triangles(5000));
  const std::size_t entries = few.grid({}).lists().occluders.size();
  EXPECT_LE(entries, Config::kEntriesOfFew);
  EXPECT_GT(entries, Config::kEntriesOfFew * 9 / 10);
  const std::size_t others = more.grid({}).lists().occluders.size();
  EXPECT_LE(others, Config::kEntriesOfEach * more.occluders.size());
  EXPECT_GT(others, Config::kEntriesOfEach * more.occluders.size() * 9 / 10);
}

/// The number of threads is that of the machine. Repeated runs show that their timing does not matter.
TEST(OccluderGrid, IsTheSameInEveryRun) {
  const Model model(large_triangles(300));
  const OccluderGrid::Config config{.regions = 4096, .entries = 50000};
  const OccluderGrid first = model.grid(config);
  for (int run = 0; run < 5; ++run) {
    const OccluderGrid other = model.grid(config);
    ASSERT_EQ(other.lists().first, first.lists().first);
    ASSERT_EQ(other.lists().occluders, first.lists().occluders);
  }
}

TEST(OccluderGrid, RepeatedPolygonsShare) {
  PolygonSoup soup;
  for (int i = 0; i < 100; ++i) add_wall(soup, 1, 0, 1, 0, 1);
  add_wall(soup, 2, 0, 1, 0, 1);
  EXPECT_EQ(Model(soup).grid().list({1.5, 0.5, 0.5}).occluders.size(), 2U);
}

}  // namespace
