// SPDX-License-Identifier: MIT
// Blocks have the whole tree, and a descent visits as few of them as can be.
#include "model/hierarchy_blocks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <span>
#include <vector>

#include "base/each_bit.h"
#include "model/bounds.h"
#include "occlude/culler/hierarchy.h"
#include "scenes.h"

namespace hierarchy_blocks_test {

using namespace occlude;
using namespace occlude::culler;

constexpr std::uint32_t kSeed = 23;

bool is_few(const HierarchyNode& node) { return node.is_leaf() || node.count <= kFewItems; }

/// Calls visit(block, above) for each block that a descent meets, where `above` is the node that it divides, or kNone.
template <class Visit>
void for_each_block(const BlockTree& tree, const Visit& visit, std::uint32_t at = 0,
                    std::uint32_t above = TreeBlock::kNone) {
  const TreeBlock& block = tree[at];
  visit(block, above);
  for_each_bit(block.divided, [&](std::uint32_t i) { for_each_block(tree, visit, block.below[i], block.node[i]); });
}

TEST(HierarchyBlocks, HaveTheWholeTree) {
  const Hierarchy hierarchy = Hierarchy::build(random_town_of_houses(kSeed, 3000), {.leaf_size = 4});
  const auto nodes = hierarchy.nodes();
  const HierarchyBlocks blocks(hierarchy);
  std::vector<int> found(hierarchy.soup().size());
  std::size_t met = 0, beside_many = 0;
  for_each_block(blocks.tree(), [&](const TreeBlock& block, std::uint32_t above) {
    ++met;
    ASSERT_EQ(block.used, (1U << block.size()) - 1) << "the first nodes are used";
    const HierarchyNode& whole = nodes[above == TreeBlock::kNone ? 0 : above];
    EXPECT_EQ(block.items().first, whole.first);
    EXPECT_EQ(block.items().count, whole.count);
    EXPECT_GT(block.size(), 1U);
    for (std::size_t i = 0; i < block.size(); ++i) {
      const HierarchyNode& node = nodes[block.node[i]];
      EXPECT_EQ(block.boxes.box(i), node.box);
      EXPECT_EQ(block.items(i).first, node.first);
      EXPECT_EQ(block.items(i).count, node.count);
      EXPECT_EQ(block.is_leaf(i), node.is_leaf());
      EXPECT_EQ(block.is_leaf(i), block.below[i] == TreeBlock::kNone);
      if (block.is_leaf(i)) {
        for (std::uint32_t p = node.first; p < node.first + node.count; ++p) ++found[p];
      }
      if (is_few(whole) || !is_few(node)) continue;
      ++beside_many;
      // So the node above it has many: nothing that is divided here has few.
      std::uint32_t parent = 0;
      while (nodes[parent].right != block.node[i] && parent + 1 != block.node[i]) ++parent;
      EXPECT_FALSE(is_few(nodes[parent]));
    }
  });
  EXPECT_EQ(met, blocks.tree().size());
  EXPECT_EQ(std::ranges::count(found, 1), std::ssize(found));
  EXPECT_GT(beside_many, 2U);
}

TEST(HierarchyBlocks, OfASingleLeafHaveIt) {
  const Hierarchy hierarchy = Hierarchy::build(random_town_of_houses(kSeed, 1), {.leaf_size = 100});
  ASSERT_EQ(hierarchy.nodes().size(), 1U);
  const HierarchyBlocks blocks(hierarchy);
  ASSERT_EQ(blocks.tree().size(), 1U);
  EXPECT_EQ(blocks.tree()[0].size(), 1U);
  EXPECT_TRUE(blocks.tree()[0].is_leaf(0));
  EXPECT_EQ(blocks.tree().items().count, hierarchy.soup().size());
}

/// The sum of the widths of nodes that are divided in a block of their own.
double visits(const HierarchyBlocks& blocks, const Hierarchy& hierarchy) {
  double sum = 0;
  for_each_block(blocks.tree(), [&](const TreeBlock&, std::uint32_t above) {
    sum += total_width(hierarchy.nodes()[above == TreeBlock::kNone ? 0 : above].box);
  });
  return sum;
}

/// The least such sum of all divisions: of all sets of nodes that are divided in the block of the node above them.
double least_visits(std::span<const HierarchyNode> nodes) {
  std::vector<std::uint32_t> inner;
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    if (!nodes[i].is_leaf()) inner.push_back(i);
  }
  if (inner.empty()) return total_width(nodes[0].box);
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t set = 0; set < 1U << inner.size(); set += 2) {  // never the root
    std::vector<bool> is_within(nodes.size());
    for (std::size_t k = 0; k < inner.size(); ++k) is_within[inner[k]] = (set >> k & 1) != 0;
    double sum = 0;
    std::size_t most = 0;
    for (const std::uint32_t i : inner) {
      if (is_within[i]) continue;
      sum += total_width(nodes[i].box);
      std::size_t parts = 0;
      const auto count = [&](const auto& self, std::uint32_t node) -> void {
        if (!is_within[node]) {
          ++parts;
          return;
        }
        self(self, node + 1);
        self(self, nodes[node].right);
      };
      count(count, i + 1);
      count(count, nodes[i].right);
      most = std::max(most, parts);
    }
    if (most <= TreeBlock::kNodes) least = std::min(least, sum);
  }
  return least;
}

TEST(HierarchyBlocks, AreVisitedAsRarelyAsCanBe) {
  std::mt19937 random(kSeed);
  for (std::size_t polygons = 1; polygons <= 14; ++polygons) {
    for (int i = 0; i < 10; ++i) {
      PolygonSoup soup;
      while (soup.size() < polygons) {
        const double size = i % 2 == 0 ? 100 : std::exp2(uniform(random, -10, 6));
        std::vector<std::uint32_t> triangle;
        for (int k = 0; k < 3; ++k) {
          triangle.push_back(
              soup.add_vertex({uniform(random, 0, size), uniform(random, 0, size), uniform(random, 0, size)}));
        }
        soup.add_polygon(triangle);
      }
      const Hierarchy hierarchy = Hierarchy::build(soup, {.leaf_size = 1});
      const double least = least_visits(hierarchy.nodes());
      EXPECT_NEAR(visits(HierarchyBlocks(hierarchy), hierarchy), least, 1e-5 * least)
          << polygons << " polygons, seed " << kSeed;
    }
  }
}

/// In a block of their own the parts of a node that is a point cost nothing, and fill blocks nevertheless.
TEST(HierarchyBlocks, AreFullAlsoWhereNothingHasAWidth) {
  PolygonSoup soup;
  for (int i = 0; i < 1000; ++i) {
    std::vector<std::uint32_t> point;
    for (int k = 0; k < 3; ++k) point.push_back(soup.add_vertex({1, 2, 3}));
    soup.add_polygon(point);
  }
  const Hierarchy hierarchy = Hierarchy::build(soup, {.leaf_size = 1});
  EXPECT_LT(HierarchyBlocks(hierarchy).tree().size(), soup.size() / 3);
}

}  // namespace hierarchy_blocks_test
