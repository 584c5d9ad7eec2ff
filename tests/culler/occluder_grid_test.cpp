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
      : box(Hierarchy::build(soup, {}).nodes()[0].box), occluders(PotentialOccluders::find(soup, {})) {}

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

}  // namespace
