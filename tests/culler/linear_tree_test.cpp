// SPDX-License-Identifier: MIT
#include "model/linear_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "model/bounds.h"
#include "scenes.h"

namespace linear_tree_test {

using namespace occlude;
using namespace occlude::culler;
using kernel::Aabb;

constexpr std::uint32_t kSeed = 41;

std::vector<Aabb> random_boxes(std::mt19937& random, std::size_t count, double extent) {
  std::vector<Aabb> boxes;
  while (boxes.size() < count) {
    const double x = uniform(random, -extent, extent), y = uniform(random, -extent, extent), z = uniform(random, 0, extent);
    const double size = uniform(random, 0, 1);
    boxes.push_back({{x, y, z}, {x + size, y + size, z + size}});
  }
  return boxes;
}

/// Returns the levels of the subtree. Expects that each node holds exactly what is below it, in the right order.
int expect_sound(const LinearTree& tree, std::span<const Aabb> boxes, std::uint32_t node, std::uint32_t leaf_size) {
  const HierarchyNode& n = tree.nodes()[node];
  Aabb box = empty_box();
  for (const std::uint32_t i : tree.order().subspan(n.first, n.count)) grow(box, boxes[i]);
  EXPECT_EQ(n.box, box) << "node " << node;
  if (n.is_leaf()) {
    EXPECT_LE(n.count, leaf_size);
    return 1;
  }
  const HierarchyNode &left = tree.nodes()[node + 1], &right = tree.nodes()[n.right];
  EXPECT_EQ(left.first, n.first);
  EXPECT_EQ(right.first, n.first + left.count);
  EXPECT_EQ(left.count + right.count, n.count);
  EXPECT_GT(left.count, 0U);
  EXPECT_GT(right.count, 0U);
  return 1 + std::max(expect_sound(tree, boxes, node + 1, leaf_size), expect_sound(tree, boxes, n.right, leaf_size));
}

TEST(LinearTree, HoldsEachBoxOnceAndExactly) {
  std::mt19937 random(kSeed);
  LinearTree tree;
  for (const std::size_t count : {0U, 1U, 2U, 8U, 9U, 100U, 5000U}) {
    for (const double extent : {0.0, 0x1p-99, 100.0, 0x1p99}) {
      for (const std::uint32_t leaf_size : {1U, 8U}) {
        const auto boxes = random_boxes(random, count, extent);
        tree.build(boxes, leaf_size);
        std::vector<std::uint32_t> order(tree.order().begin(), tree.order().end());
        std::ranges::sort(order);
        for (std::uint32_t i = 0; i < count; ++i) ASSERT_EQ(order[i], i);
        ASSERT_EQ(order.size(), count);
        if (count == 0) {
          EXPECT_TRUE(tree.nodes().empty());
        } else {
          EXPECT_LE(expect_sound(tree, boxes, 0, leaf_size), 30 + 14) << "seed " << kSeed;
        }
      }
    }
  }
}

TEST(LinearTree, IsBalancedWhereAllIsAtOnePlace) {
  const std::vector<Aabb> boxes(1024, Aabb{{1, 1, 1}, {2, 2, 2}});
  LinearTree tree;
  tree.build(boxes, 1);
  EXPECT_EQ(expect_sound(tree, boxes, 0, 1), 11);
}

TEST(LinearTree, PutsWhatIsNearTogether) {
  std::mt19937 random(kSeed);
  const auto boxes = random_boxes(random, 4096, 500);
  LinearTree tree;
  tree.build(boxes, 8);
  double leaves = 0;
  for (const HierarchyNode& n : tree.nodes()) {
    if (n.is_leaf()) leaves += half_area(n.box);
  }
  EXPECT_LT(leaves, 0.2 * half_area(tree.nodes()[0].box) * static_cast<double>(tree.nodes().size() + 1) / 2);
}

}  // namespace linear_tree_test
