// SPDX-License-Identifier: MIT
#include "occlude/culler/hierarchy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>
#include <variant>

#include "occlude/kernel/containment.h"
#include "scenes.h"

namespace hierarchy_test {

using namespace occlude::culler;

bool encloses(const occlude::kernel::Obb& box, const glm::dvec3& v) {
  return occlude::kernel::contains(box, {v.x, v.y, v.z});
}

bool encloses(const occlude::kernel::Aabb& box, const glm::dvec3& v) {
  return v.x >= box.min.x && v.x <= box.max.x && v.y >= box.min.y && v.y <= box.max.y && v.z >= box.min.z &&
         v.z <= box.max.z;
}

void check(SoupView soup, const Hierarchy& hierarchy, std::uint32_t leaf_size) {
  std::multiset<std::uint32_t> originals;
  for (std::size_t p = 0; p < soup.size(); ++p) {
    originals.insert(hierarchy.original(p));
    const auto mine = hierarchy.soup().loop(p), given = soup.loop(hierarchy.original(p));
    ASSERT_TRUE(std::equal(mine.begin(), mine.end(), given.begin(), given.end()));
    const Hierarchy::Node& leaf = hierarchy.nodes()[hierarchy.leaf_of(static_cast<std::uint32_t>(p))];
    ASSERT_TRUE(leaf.is_leaf() && p >= leaf.first && p - leaf.first < leaf.count) << "polygon " << p;
  }
  ASSERT_EQ(originals.size(), soup.size());
  ASSERT_EQ(std::set<std::uint32_t>(originals.begin(), originals.end()).size(), soup.size());

  std::size_t in_leaves = 0;
  const auto nodes = hierarchy.nodes();
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const Hierarchy::Node& node = nodes[n];
    for (std::uint32_t p = node.first; p < node.first + node.count; ++p) {
      for (const std::uint32_t index : hierarchy.soup().loop(p)) {
        const glm::dvec3& v = hierarchy.soup().vertices[index];
        ASSERT_TRUE(encloses(node.box, v));
        ASSERT_TRUE(hierarchy.ask(static_cast<std::uint32_t>(n), [&](const auto& box) { return encloses(box, v); }));
      }
    }
    if (node.is_leaf()) {
      ASSERT_EQ(node.first, in_leaves);
      ASSERT_LE(node.count, leaf_size);
      ASSERT_GT(node.count, 0U);
      in_leaves += node.count;
    } else {
      ASSERT_EQ(nodes[n + 1].first, node.first);
      ASSERT_EQ(nodes[node.right].first, node.first + nodes[n + 1].count);
      ASSERT_EQ(nodes[n + 1].count + nodes[node.right].count, node.count);
    }
  }
  ASSERT_EQ(in_leaves, soup.size());
}

TEST(Hierarchy, EveryPolygonInExactlyOneLeafAndEnclosed) {
  for (const std::uint32_t leaf_size : {1U, 4U, 16U}) {
    const PolygonSoup soup = random_town(7, 3000);
    check(soup, Hierarchy::build(soup, {.leaf_size = leaf_size}), leaf_size);
  }
}

/// The town turned about a vertical axis and moved: no wall is parallel to a coordinate axis.
PolygonSoup turned_town(double scale, double offset) {
  PolygonSoup soup = random_town(7, 3000);
  for (glm::dvec3& v : soup.vertices) {
    v = scale * glm::dvec3{0.8 * v.x - 0.6 * v.y, 0.6 * v.x + 0.8 * v.y, v.z} + glm::dvec3{offset, offset, 0};
  }
  return soup;
}

TEST(Hierarchy, OrientedBoxesHoldTheirPolygonsExactly) {
  for (const double scale : {1.0, 0x1p-90, 0x1p90}) {
    const PolygonSoup soup = turned_town(scale, 0);
    const Hierarchy hierarchy = Hierarchy::build(soup, {.leaf_size = 4, .bounds = Bounds::obb});
    check(soup, hierarchy, 4);
    EXPECT_GT(hierarchy.oriented(), 200U) << "scale " << scale;
  }
  const PolygonSoup far = turned_town(1, 4e9);
  const Hierarchy hierarchy = Hierarchy::build(far, {.leaf_size = 4, .bounds = Bounds::obb});
  check(far, hierarchy, 4);
  EXPECT_GT(hierarchy.oriented(), 200U);
}

/// A town along a street that is parallel to no axis, so that oriented boxes of any size pay.
PolygonSoup street() {
  PolygonSoup soup = random_town(7, 30000);
  for (glm::dvec3& v : soup.vertices) v = {0.8 * v.x - 0.06 * v.y, 0.6 * v.x + 0.08 * v.y, v.z};
  return soup;
}

TEST(Hierarchy, LargeTreesHoldTheirPolygons) {
  const PolygonSoup soup = street();
  for (const Bounds bounds : {Bounds::aabb, Bounds::obb}) {
    const Hierarchy::Config config{.leaf_size = 4, .bounds = bounds};
    const Hierarchy built = Hierarchy::build(soup, config);
    check(soup, built, 4);
    std::size_t large = 0;  // oriented boxes of many polygons
    for (std::uint32_t n = 0; n < built.nodes().size(); ++n) {
      const bool is_oriented = std::holds_alternative<occlude::kernel::Obb>(built.volume(n));
      large += is_oriented && built.nodes()[n].count > 1000 ? 1 : 0;
    }
    EXPECT_EQ(large > 10, bounds == Bounds::obb) << large;
  }
}

/// Walls that are parallel to the axes keep axis-aligned boxes. The box of a wall turned by 45 degrees shrinks to the wall.
TEST(Hierarchy, OrientedBoxesWhereTheyAreSmaller) {
  PolygonSoup aligned, turned;
  for (int i = 0; i < 64; ++i) {
    add_wall(aligned, i, 0, 5, 0, 3);
    add(turned, {{i, 0, 0}, {i + 5, 5, 0}, {i + 5, 5, 3}, {i, 0, 3}});
  }
  EXPECT_EQ(Hierarchy::build(aligned, {.leaf_size = 1, .bounds = Bounds::obb}).oriented(), 0U);
  const Hierarchy hierarchy = Hierarchy::build(turned, {.leaf_size = 1, .bounds = Bounds::obb});
  for (std::uint32_t n = 0; n < hierarchy.nodes().size(); ++n) {
    if (!hierarchy.nodes()[n].is_leaf()) continue;
    const Box volume = hierarchy.volume(n);
    const auto* const box = std::get_if<occlude::kernel::Obb>(&volume);
    ASSERT_NE(box, nullptr);
    EXPECT_LT(glm::length(glm::dvec3{box->half_edges[2].x, box->half_edges[2].y, box->half_edges[2].z}), 1e-12);
  }
}

/// Triangles have a diagonal, and corners may lie out of their plane.
TEST(Hierarchy, OrientedBoxesAlongWallsOfTrianglesAndBentOnes) {
  for (const double bend : {0.0, 1e-9, 1e-6, 1e-3}) {
    PolygonSoup soup;
    for (int i = 0; i < 16; ++i) {
      const glm::dvec3 p{i, 0, 0}, q{i + 5, 5, 0}, up{0, 0, 7}, out{bend, -bend, 0};
      add(soup, {p, q, q + up});
      add(soup, {p, q + up, p + up + out});
      add(soup, {p, q, q + up, p + up + out});
    }
    const Hierarchy hierarchy = Hierarchy::build(soup, {.leaf_size = 1, .bounds = Bounds::obb});
    check(soup, hierarchy, 1);
    for (std::uint32_t n = 0; n < hierarchy.nodes().size(); ++n) {
      if (!hierarchy.nodes()[n].is_leaf()) continue;
      const Box volume = hierarchy.volume(n);
      const auto* const box = std::get_if<occlude::kernel::Obb>(&volume);
      ASSERT_NE(box, nullptr) << "bend " << bend;
      double smallest = 1e9;
      for (const auto& [x, y, z] : box->half_edges) smallest = std::min(smallest, glm::length(glm::dvec3{x, y, z}));
      EXPECT_LE(smallest, bend + 1e-12);
    }
  }
}

TEST(Hierarchy, CoincidingPolygonsAreSplitAllTheSame) {
  PolygonSoup soup;
  for (int i = 0; i < 5000; ++i) add_wall(soup, 1, 0, 1, 0, 1);
  check(soup, Hierarchy::build(soup, {.leaf_size = 4}), 4);
}

/// The most nodes on a way from the root, less one.
std::uint32_t levels_of(std::span<const Hierarchy::Node> nodes) {
  std::vector<std::uint32_t> level(nodes.size());
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (!nodes[n].is_leaf()) level[n + 1] = level[nodes[n].right] = level[n] + 1;
  }
  return *std::ranges::max_element(level);
}

/// Walls that come nearer and nearer to each other. They are so large that all splits seem to cost the same, and each takes
/// one of them from the rest.
TEST(Hierarchy, NoTreeIsDeeperThanAStack) {
  PolygonSoup soup;
  for (double x = 1; x > 0x1p-90; x *= 0.9) add_wall(soup, -x, -0x1p90, 0x1p90, -0x1p90, 0x1p90);
  ASSERT_GT(soup.size(), 2 * kMostLevels);
  const Hierarchy hierarchy = Hierarchy::build(soup, {.leaf_size = 1});
  check(soup, hierarchy, 1);
  EXPECT_EQ(levels_of(hierarchy.nodes()), kMostLevels);
  EXPECT_LT(levels_of(Hierarchy::build(random_town(7, 3000), {.leaf_size = 1}).nodes()), 32U) << "as deep as by halving";
}

TEST(Hierarchy, ExtremeCoordinates) {
  PolygonSoup soup;
  for (int i = 0; i < 200; ++i) add_wall(soup, (i % 2 ? 1 : -1) * 0x1p100, i, i + 1, 0, 0x1p100);
  check(soup, Hierarchy::build(soup, {.leaf_size = 4}), 4);
}

TEST(Hierarchy, OrientedBoxesOfExtremeOrDegeneratePolygons) {
  PolygonSoup soup;
  for (int i = 0; i < 50; ++i) {
    const double sign = i % 2 ? 1 : -1;
    add(soup, {{sign * 0x1p100, 0x1p100, i}, {0, -sign * 0x1p100, i}, {0x1p100, 0, 0x1p100}});
    add(soup, {{i, i, i}, {i, i, i}, {i, i, i}});
    add(soup, {{i, 0, 0}, {i + 1, 1, 0}, {i + 2, 2, 0}});
    add(soup, {{0x1p-100, 0, 0}, {0, 0x1p-100, 0}, {0x1p-100, 0x1p-100, 0}});
  }
  check(soup, Hierarchy::build(soup, {.leaf_size = 2, .bounds = Bounds::obb}), 2);
}

TEST(Hierarchy, OnePolygon) {
  PolygonSoup soup;
  add_wall(soup, 1, 0, 1, 0, 1);
  check(soup, Hierarchy::build(soup, {}), 16);
}

TEST(Hierarchy, TrianglesAreCountedAlongTheSoup) {
  PolygonSoup soup;
  add_wall(soup, 1, 0, 1, 0, 1);
  add(soup, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const Hierarchy hierarchy = Hierarchy::build(soup, {});
  EXPECT_EQ(hierarchy.first_triangle(0), 0U);
  EXPECT_EQ(hierarchy.first_triangle(2), 3U);
}

}  // namespace hierarchy_test
