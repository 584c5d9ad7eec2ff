// SPDX-License-Identifier: MIT
#include "occlude/culler/hierarchy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "scenes.h"

namespace {

using namespace occlude::culler;

bool encloses(const occlude::kernel::Aabb& box, const glm::dvec3& v) {
  return v.x >= box.min.x && v.x <= box.max.x && v.y >= box.min.y && v.y <= box.max.y && v.z >= box.min.z &&
         v.z <= box.max.z;
}

void check(const PolygonSoup& soup, const Hierarchy& hierarchy, std::uint32_t leaf_size) {
  std::multiset<std::uint32_t> originals;
  for (std::size_t p = 0; p < soup.size(); ++p) {
    originals.insert(hierarchy.original(p));
    const auto mine = hierarchy.soup().loop(p), given = soup.loop(hierarchy.original(p));
    ASSERT_TRUE(std::equal(mine.begin(), mine.end(), given.begin(), given.end()));
  }
  ASSERT_EQ(originals.size(), soup.size());
  ASSERT_EQ(std::set<std::uint32_t>(originals.begin(), originals.end()).size(), soup.size());

  std::size_t in_leaves = 0;
  const auto nodes = hierarchy.nodes();
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const Hierarchy::Node& node = nodes[n];
    for (std::uint32_t p = node.first; p < node.first + node.count; ++p) {
      for (const std::uint32_t index : hierarchy.soup().loop(p)) {
        ASSERT_TRUE(encloses(node.box, hierarchy.soup().vertices[index]));
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

TEST(Hierarchy, CoincidingPolygonsAreSplitAllTheSame) {
  PolygonSoup soup;
  for (int i = 0; i < 5000; ++i) add_wall(soup, 1, 0, 1, 0, 1);
  check(soup, Hierarchy::build(soup, {.leaf_size = 4}), 4);
}

TEST(Hierarchy, ExtremeCoordinates) {
  PolygonSoup soup;
  for (int i = 0; i < 200; ++i) add_wall(soup, (i % 2 ? 1 : -1) * 0x1p100, i, i + 1, 0, 0x1p100);
  check(soup, Hierarchy::build(soup, {.leaf_size = 4}), 4);
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

}  // namespace
