// SPDX-License-Identifier: MIT
#include "occlude/culler/occluder_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "scenes.h"

namespace {

using namespace occlude::culler;

OccluderGrid grid_over(const Hierarchy& hierarchy, const OccluderGrid::Config& config) {
  const PolygonSoup& soup = hierarchy.soup();
  return OccluderGrid::build(soup, ConvexRegions::find(soup), hierarchy.nodes()[0].box, config);
}

TEST(AreaAngle, IsAreaTimesCosineOverSquaredDistance) {
  const PotentialOccluder wall{{10, 0, 0}, {4, 0, 0}, {}};
  EXPECT_DOUBLE_EQ(wall.area_angle({0, 0, 0}), 0.04);
  EXPECT_DOUBLE_EQ(wall.area_angle({20, 0, 0}), 0.04);  // hides from both sides
  EXPECT_DOUBLE_EQ(wall.area_angle({10, 5, 0}), 0);     // edge-on
  EXPECT_DOUBLE_EQ(wall.area_angle({0, 10, 0}), 4 * std::sqrt(0.5) / 200);
  EXPECT_EQ(wall.area_angle({10, 0, 0}), 0);
}

TEST(OccluderGrid, ListsEveryOccluderAboveTheThreshold) {
  const PolygonSoup soup = random_town(11, 2000);
  const Hierarchy hierarchy = Hierarchy::build(soup, {});
  const OccluderGrid::Config config{.threshold = 0.05, .regions = 4096};
  const OccluderGrid grid = grid_over(hierarchy, config);
  std::mt19937 random(5);
  std::size_t above = 0, listed = 0;
  for (int i = 0; i < 300; ++i) {
    const glm::dvec3 eye{uniform(random, -50, 50), uniform(random, -50, 50), uniform(random, 0, 6)};
    const auto list = grid.list(eye);
    listed += list.size();
    for (std::uint32_t p = 0; p < soup.size(); ++p) {
      if (grid.occluder(p).area_angle(eye) < config.threshold) continue;
      ++above;
      ASSERT_NE(std::find(list.begin(), list.end(), p), list.end());
    }
  }
  EXPECT_GT(above, 300U);
  EXPECT_LT(listed, 300 * soup.size() / 4);  // and it does leave most out
}

TEST(OccluderGrid, PointsOutsideTheModelGoToTheNearestRegion) {
  const PolygonSoup soup = random_town(3, 500);
  const OccluderGrid grid = grid_over(Hierarchy::build(soup, {}), {});
  EXPECT_EQ(grid.list({1e9, -1e9, 1e9}).data(), grid.list({1e12, -1e12, 1e12}).data());
}

TEST(OccluderGrid, FlatAndDegenerateModels) {
  PolygonSoup flat;
  add_wall(flat, 1, 0, 1, 0, 1);
  EXPECT_EQ(grid_over(Hierarchy::build(flat, {}), {}).list({1, 0.5, 0.5}).size(), 1U);
  PolygonSoup point;
  add(point, {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}});
  EXPECT_EQ(grid_over(Hierarchy::build(point, {}), {}).entries(), 0U);
}

}  // namespace
