// SPDX-License-Identifier: MIT
#include "frusta/occluder_lists.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "occlude/culler/hierarchy.h"
#include "scenes.h"

namespace occluder_lists_test {

using namespace occlude::culler;

struct Model {
  explicit Model(const PolygonSoup& soup)
      : tree(Hierarchy::build(soup, {.leaf_size = 2})), occluders(PotentialOccluders::find(SharedSoup(soup), {})) {}

  [[nodiscard]] Space space() const { return {tree.nodes()[0].box, tree.nodes()}; }
  [[nodiscard]] OccluderLists lists(const ListConfig& config) const {
    return OccluderLists::build(occluders, space(), config);
  }

  Hierarchy tree;
  PotentialOccluders occluders;
};

class Lists : public testing::TestWithParam<RegionKind> {};

INSTANTIATE_TEST_SUITE_P(Kinds, Lists, testing::Values(RegionKind::grid, RegionKind::tree),
                         [](const auto& of) { return of.param == RegionKind::grid ? "grid" : "tree"; });

TEST(AreaAngle, IsAreaTimesCosineOverSquaredDistance) {
  const PotentialOccluder wall{.centre = {10, 0, 0}, .area_normal = {4, 0, 0}};
  EXPECT_DOUBLE_EQ(wall.area_angle({0, 0, 0}), 0.04);
  EXPECT_DOUBLE_EQ(wall.area_angle({20, 0, 0}), 0.04);  // hides from both sides
  EXPECT_DOUBLE_EQ(wall.area_angle({10, 5, 0}), 0);     // edge-on
  EXPECT_DOUBLE_EQ(wall.area_angle({0, 10, 0}), 4 * std::sqrt(0.5) / 200);
  EXPECT_EQ(wall.area_angle({10, 0, 0}), 0);
}

TEST_P(Lists, HaveEveryOccluderAboveTheThreshold) {
  const PolygonSoup soup = random_town_of_houses(11, 2000);
  const Model model(soup);
  const ListConfig config{.kind = GetParam(), .threshold = 0.05, .regions = 4096};
  const OccluderLists lists = model.lists(config);
  std::mt19937 random(5);
  std::size_t above = 0, listed = 0;
  for (int i = 0; i < 300; ++i) {
    const glm::dvec3 eye{uniform(random, -50, 50), uniform(random, -50, 50), uniform(random, 0, 6)};
    const auto list = lists.list(eye).occluders;
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

TEST_P(Lists, OfFlatAndDegenerateModels) {
  PolygonSoup flat;
  add_wall(flat, 1, 0, 1, 0, 1);
  EXPECT_EQ(Model(flat).lists({.kind = GetParam()}).list({1, 0.5, 0.5}).occluders.size(), 1U);
  PolygonSoup point;
  add(point, {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}});
  EXPECT_EQ(Model(point).lists({.kind = GetParam()}).stored().occluders.size(), 0U);
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

TEST_P(Lists, KeepToTheirBudgetLargestFirst) {
  const Model model(large_triangles(500));
  const OccluderLists all = model.lists({.kind = GetParam(), .regions = 512});
  constexpr std::size_t kEntries = 20000;
  const OccluderLists some = model.lists({.kind = GetParam(), .regions = 512, .entries = kEntries});
  ASSERT_GT(all.stored().occluders.size(), 3 * kEntries);
  EXPECT_LE(some.stored().occluders.size(), kEntries);
  EXPECT_GT(some.stored().occluders.size(), kEntries * 9 / 10);
  std::size_t largest_listed = 0, listed = 0;
  for (std::size_t region = 0; region < some.partition().regions(); ++region) {
    const auto before = all.list(region).occluders, kept = some.list(region).occluders;
    EXPECT_TRUE(std::ranges::includes(before, kept));
    EXPECT_GT(kept.size(), 20U) << "no list is cut more than others";
    if (before.empty()) continue;
    const auto [low, high] = some.partition().box(region);
    const glm::dvec3 middle{(low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2};
    const auto looks = [&](std::uint32_t i) { return model.occluders[i].area_angle(middle); };
    const auto largest = *std::ranges::max_element(before, {}, looks);
    if (!kept.empty()) ++listed;
    if (std::ranges::binary_search(kept, largest)) ++largest_listed;
  }
  // Lists keep what looks largest from somewhere in the region, not from its middle. Nodes are longer than cubes.
  EXPECT_GT(largest_listed, listed * (GetParam() == RegionKind::grid ? 9 : 7) / 10);
}

TEST_P(Lists, OfABudgetThatIsNotSpentNothingIsCut) {
  const Model model(random_town_of_houses(4, 1500));
  constexpr double kThreshold = 0.1;  // with a lower one, so small a model spends its budget
  const auto within = [&](std::size_t budget) {
    return model.lists({.kind = GetParam(), .threshold = kThreshold, .entries = budget}).stored().occluders;
  };
  const auto all = within(ListConfig{}.entries);
  ASSERT_LT(all.size(), ListConfig::kEntriesOfFew);
  EXPECT_EQ(within(all.size()), all);
  EXPECT_LT(within(all.size() - 1).size(), all.size());
}

TEST(OccluderLists, OfASmallModelItsBudgetIsSmall) {
  const Model few(large_triangles(2000)), more(large_triangles(5000));
  const std::size_t entries = few.lists({}).stored().occluders.size();
  EXPECT_LE(entries, ListConfig::kEntriesOfFew);
  EXPECT_GT(entries, ListConfig::kEntriesOfFew * 9 / 10);
  const std::size_t others = more.lists({}).stored().occluders.size();
  EXPECT_LE(others, ListConfig::kEntriesOfEach * more.occluders.size());
  EXPECT_GT(others, ListConfig::kEntriesOfEach * more.occluders.size() * 9 / 10);
}

/// The number of threads is that of the machine. Repeated runs show that their timing does not matter.
TEST_P(Lists, AreTheSameInEveryRun) {
  const Model model(large_triangles(300));
  const ListConfig config{.kind = GetParam(), .regions = 4096, .entries = 50000};
  const OccluderLists first = model.lists(config);
  for (int run = 0; run < 5; ++run) {
    const OccluderLists other = model.lists(config);
    ASSERT_EQ(other.stored().first, first.stored().first);
    ASSERT_EQ(other.stored().occluders, first.stored().occluders);
  }
}

TEST(OccluderLists, RepeatedPolygonsShare) {
  PolygonSoup soup;
  for (int i = 0; i < 100; ++i) add_wall(soup, 1, 0, 1, 0, 1);
  add_wall(soup, 2, 0, 1, 0, 1);
  EXPECT_EQ(Model(soup).lists({}).list({1.5, 0.5, 0.5}).occluders.size(), 2U);
}

}  // namespace occluder_lists_test
