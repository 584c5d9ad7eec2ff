// SPDX-License-Identifier: MIT
#include "packed_tree.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "bounds.h"
#include "curve_order.h"
#include "scenes.h"

namespace {

using namespace occlude;
using namespace occlude::culler;
using kernel::Aabb;

constexpr std::uint32_t kSeed = 43;

std::vector<Aabb> random_boxes(std::mt19937& random, std::size_t count) {
  std::vector<Aabb> boxes;
  while (boxes.size() < count) {
    const double x = uniform(random, -100, 100), y = uniform(random, -100, 100), z = uniform(random, 0, 100);
    const double size = uniform(random, 0, 1);
    boxes.push_back({{x, y, z}, {x + size, y + size, z + size}});
  }
  return boxes;
}

/// Expects that each box of a block is exactly the box around its items, and that the items follow each other. Returns the
/// item after the last.
std::uint32_t expect_sound(const PackedTree& tree, const PackedTree::At& at, std::uint32_t first) {
  const unsigned used = tree.used(at);
  EXPECT_NE(used, 0U);
  EXPECT_EQ(used & (used + 1), 0U) << "the first ones are used";
  for (std::uint32_t i = 0; i < PackedTree::kWidth && (used >> i & 1U) != 0; ++i) {
    const auto [begin, count] = tree.items(at, i);
    EXPECT_EQ(begin, first);
    Aabb box = empty_box();
    for (std::uint32_t item = begin; item < begin + count; ++item) grow(box, tree.item(item));
    EXPECT_EQ(tree.block(at).box(i), box) << "level " << at.level << ", block " << at.block;
    first = begin + count;
    if (at.level > 0) {
      EXPECT_EQ(expect_sound(tree, PackedTree::below(at, i), begin), first);
    } else {
      EXPECT_EQ(count, 1U);
    }
  }
  return first;
}

TEST(PackedTree, HoldsEachBoxOnceAndExactly) {
  std::mt19937 random(kSeed);
  CurveOrder curve;
  PackedTree tree;
  for (const std::size_t count : {1U, 7U, 8U, 9U, 64U, 65U, 512U, 513U, 5000U, 3U}) {
    const auto boxes = random_boxes(random, count);
    curve.sort(boxes);
    tree.build(boxes, curve.order());
    ASSERT_FALSE(tree.empty());
    EXPECT_EQ(expect_sound(tree, tree.root(), 0), count);
    Aabb all = empty_box();
    for (std::uint32_t i = 0; i < count; ++i) {
      EXPECT_EQ(tree.item(i), boxes[curve.order()[i]]);
      grow(all, boxes[i]);
    }
    EXPECT_EQ(tree.box(), all);
  }
}

TEST(PackedTree, IsEmptyWithoutBoxes) {
  PackedTree tree;
  EXPECT_TRUE(tree.empty());
  const std::vector<Aabb> boxes(9, Aabb{{1, 1, 1}, {2, 2, 2}});
  CurveOrder curve;
  curve.sort(boxes);
  tree.build(boxes, curve.order());
  EXPECT_FALSE(tree.empty());
  tree.build({}, {});
  EXPECT_TRUE(tree.empty());
  EXPECT_EQ(tree.box(), empty_box());
}

TEST(PackedTree, PutsWhatIsNearTogether) {
  std::mt19937 random(kSeed);
  const auto boxes = random_boxes(random, 4096);
  CurveOrder curve;
  curve.sort(boxes);
  PackedTree tree;
  tree.build(boxes, curve.order());
  double leaves = 0;
  for (std::uint32_t i = 0; i < 4096 / 8; ++i) {
    const PackedTree::At at{1, i / 8};
    leaves += half_area(tree.block(at).box(i % 8));
  }
  EXPECT_LT(leaves, 0.1 * half_area(tree.box()) * (4096.0 / 8));
}

}  // namespace
