// SPDX-License-Identifier: MIT
#include "frusta/partition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "scenes.h"

namespace partition_test {

using namespace occlude::culler;
using occlude::kernel::Aabb;
Hierarchy tree_of(const PolygonSoup& soup) { return Hierarchy::build(soup, {.leaf_size = 4}); }

Partition partition(RegionKind kind, const Hierarchy& tree, double regions) {
  return Partition::make(kind, {tree.nodes()[0].box, tree.nodes()}, regions);
}

double distance(const Aabb& box, const glm::dvec3& point) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double beyond = std::max({box.min[axis] - point[axis], point[axis] - box.max[axis], 0.0});
    sum += beyond * beyond;
  }
  return std::sqrt(sum);
}

double volume(const Aabb& box) { return (box.max.x - box.min.x) * (box.max.y - box.min.y) * (box.max.z - box.min.z); }

glm::dvec3 point_in(const Aabb& box, std::mt19937& random) {
  glm::dvec3 point;
  for (int axis = 0; axis < 3; ++axis) point[axis] = uniform(random, box.min[axis], box.max[axis]);
  return point;
}

class Partitions : public testing::TestWithParam<RegionKind> {};

INSTANTIATE_TEST_SUITE_P(Kinds, Partitions, testing::Values(RegionKind::grid, RegionKind::tree),
                         [](const auto& of) { return of.param == RegionKind::grid ? "grid" : "tree"; });

TEST_P(Partitions, EveryPointIsInOneRegion) {
  const Hierarchy tree = tree_of(random_town(11, 2000));
  const Partition regions = partition(GetParam(), tree, 300);
  std::mt19937 random(5);
  for (int i = 0; i < 500; ++i) {
    const glm::dvec3 point = point_in(tree.nodes()[0].box, random);
    std::vector<std::size_t> holding;
    for (std::size_t region = 0; region < regions.regions(); ++region) {
      if (distance(regions.box(region), point) == 0) holding.push_back(region);
    }
    ASSERT_EQ(holding, std::vector{regions.region_at(point)});
  }
}

TEST_P(Partitions, APointOnAPlaneIsInTheUpperCell) {
  const Hierarchy tree = tree_of(random_town(11, 2000));
  const Partition regions = partition(GetParam(), tree, 300);
  std::mt19937 random(6);
  std::size_t planes = 0;
  for (std::size_t cell = 0; cell < regions.cells().size(); ++cell) {
    const Partition::Cell& divided = regions.cells()[cell];
    if (divided.is_region()) continue;
    ++planes;
    const auto axis = static_cast<int>(divided.axis);
    glm::dvec3 point = point_in(regions.cell_box(cell), random);
    point[axis] = divided.plane;
    const Aabb box = regions.box(regions.region_at(point));
    ASSERT_EQ(distance(box, point), 0);
    ASSERT_EQ(box.min[axis], divided.plane);
    point[axis] = std::nextafter(divided.plane, -std::numeric_limits<double>::infinity());
    const Aabb below = regions.box(regions.region_at(point));
    ASSERT_EQ(distance(below, point), 0);
    ASSERT_EQ(below.max[axis], divided.plane);
  }
  EXPECT_EQ(planes, regions.regions() - 1);
}

TEST_P(Partitions, RegionsFillTheBoxAndDoNotOverlap) {
  const Hierarchy tree = tree_of(random_town(3, 1000));
  const Partition regions = partition(GetParam(), tree, 100);
  double sum = 0;
  for (std::size_t a = 0; a < regions.regions(); ++a) {
    const Aabb box = regions.box(a);
    sum += volume(box);
    ASSERT_GT(volume(box), 0);
    for (std::size_t b = 0; b < a; ++b) {
      const Aabb other = regions.box(b);
      bool is_apart = false;
      for (int axis = 0; axis < 3; ++axis) {
        is_apart |= box.min[axis] >= other.max[axis] || other.min[axis] >= box.max[axis];
      }
      ASSERT_TRUE(is_apart) << a << " and " << b;
    }
  }
  EXPECT_NEAR(sum, volume(regions.cell_box(0)), 1e-9 * sum);
}

TEST_P(Partitions, PointsOutsideAreInTheNearestRegion) {
  const Hierarchy tree = tree_of(random_town(3, 1000));
  const Partition regions = partition(GetParam(), tree, 100);
  std::mt19937 random(7);
  for (int i = 0; i < 300; ++i) {
    const glm::dvec3 point{uniform(random, -200, 200), uniform(random, -200, 200), uniform(random, -90, 100)};
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t region = 0; region < regions.regions(); ++region) {
      nearest = std::min(nearest, distance(regions.box(region), point));
    }
    ASSERT_EQ(distance(regions.box(regions.region_at(point)), point), nearest);
  }
  EXPECT_EQ(regions.region_at({1e9, -1e9, 1e9}), regions.region_at({1e12, -1e12, 1e12}));
}

TEST_P(Partitions, FlatAndDegenerateModels) {
  PolygonSoup flat;
  for (int y = 0; y < 40; ++y) add_wall(flat, 1, y, y + 1, 0, 1);
  const Partition wall = partition(GetParam(), tree_of(flat), 8);
  EXPECT_GT(wall.regions(), 4U);
  EXPECT_NE(wall.region_at({1, 0.5, 0.5}), wall.region_at({1, 39.5, 0.5}));
  PolygonSoup points;
  for (int i = 0; i < 40; ++i) add(points, {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}});
  EXPECT_EQ(partition(GetParam(), tree_of(points), 8).regions(), 1U);
  EXPECT_EQ(Partition::make(GetParam(), {.box = {{0, 0, 0}, {1, 1, 1}}}, 1).regions(),
            GetParam() == RegionKind::grid ? 8U : 1U);
}

TEST_P(Partitions, RefusesNumbersThatCannotBe) {
  const Hierarchy tree = tree_of(random_town(9, 20));
  for (const double regions : {0.0, -8.0, 0.5, 1e30, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(static_cast<void>(partition(GetParam(), tree, regions)), std::invalid_argument);
  }
}

TEST(PartitionByGrid, RegionsAreCubesOfOneSize) {
  const Hierarchy tree = tree_of(random_town(3, 1000));
  const Partition grid = partition(RegionKind::grid, tree, 500);
  EXPECT_GE(grid.regions(), 500U);
  EXPECT_LE(grid.regions(), 1000U);
  const Aabb first = grid.box(0);
  const double edge = first.max.x - first.min.x;
  for (std::size_t region = 0; region < grid.regions(); ++region) {
    const Aabb box = grid.box(region);
    for (int axis = 0; axis < 3; ++axis) ASSERT_NEAR(box.max[axis] - box.min[axis], edge, 1e-12 * edge);
  }
}

/// Two heaps of small triangles, three units apart.
PolygonSoup two_heaps() {
  PolygonSoup soup;
  for (const double x : {0.0, 4.0}) {
    for (int i = 0; i < 16; ++i) {
      const double y = i / 16.0;
      add(soup, {{x, y, 0}, {x + 1, y, 0}, {x, y, 1}});
    }
  }
  return soup;
}

TEST(PartitionByTree, PlanesLieBetweenChildren) {
  const Partition regions = partition(RegionKind::tree, tree_of(two_heaps()), 2);
  ASSERT_EQ(regions.regions(), 2U);
  EXPECT_EQ(regions.cells()[0].axis, 0U);
  EXPECT_EQ(regions.cells()[0].plane, 2.5);
}

TEST(PartitionByTree, HasNoMoreRegionsThanWantedAndThanLeaves) {
  const Hierarchy tree = tree_of(random_town(3, 1000));
  const auto is_leaf = [](const HierarchyNode& node) { return node.is_leaf(); };
  const auto leaves = static_cast<std::size_t>(std::ranges::count_if(tree.nodes(), is_leaf));
  for (const double wanted : {1.0, 2.0, 17.0, 100.0}) {
    EXPECT_EQ(partition(RegionKind::tree, tree, wanted).regions(), static_cast<std::size_t>(wanted));
  }
  const std::size_t most = partition(RegionKind::tree, tree, 1e6).regions();
  EXPECT_LE(most, leaves);
  EXPECT_GT(most, leaves / 2);
}

/// The right child reaches far below the plane at 5 that is between it and the left one. Its own plane at 2.5 misses its
/// cell, all of which goes to its upper child, whose plane divides it.
TEST(PartitionByTree, APlaneThatMissesItsCellIsPassedOver) {
  const auto node = [](double from, double to, std::uint32_t right) {
    return HierarchyNode{.box = {{from, 0, 0}, {to, 1, 1}}, .count = 1, .right = right};
  };
  const std::vector<HierarchyNode> nodes{node(0, 9, 2), node(0, 9, 0), node(1, 9, 4), node(1, 2, 0),
                                         node(3, 9, 6), node(3, 6, 0), node(7, 9, 0)};
  const Partition regions = Partition::make(RegionKind::tree, {nodes[0].box, nodes}, 9);
  ASSERT_EQ(regions.regions(), 3U);
  EXPECT_EQ(regions.cells()[0].plane, 5);
  EXPECT_EQ(regions.region_at({2, 0, 0}), 0U);
  EXPECT_EQ(regions.box(1).min.x, 5);
  EXPECT_EQ(regions.box(1).max.x, 6.5);
  EXPECT_EQ(regions.box(2).max.x, 9);
}

TEST(PartitionByTree, IsSmallerWherePolygonsAre) {
  PolygonSoup soup = random_town(5, 2000);
  add(soup, {{1000, 0, 0}, {1001, 0, 0}, {1000, 1, 0}});
  const Hierarchy tree = tree_of(soup);
  const Partition regions = partition(RegionKind::tree, tree, 200);
  EXPECT_LT(volume(regions.box(regions.region_at({0, 0, 1}))), volume(regions.box(regions.region_at({800, 0, 1}))) / 100);
}

}  // namespace partition_test
