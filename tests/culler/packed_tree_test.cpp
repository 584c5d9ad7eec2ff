// SPDX-License-Identifier: MIT
#include "model/packed_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "model/bounds.h"
#include "model/curve_order.h"
#include "model/split_order.h"
#include "scenes.h"

namespace packed_tree_test {

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

/// The surface of all boxes of the tree but those of the items, over that of the root. The visits of a descent grow with it.
double surface(const PackedTree& tree) {
  double sum = 0;
  for (std::uint32_t level = tree.root().level; level > 0; --level) {
    const std::uint32_t blocks = ((tree.size() - 1) >> (3 * (level + 1))) + 1;
    for (std::uint32_t block = 0; block < blocks; ++block) {
      for (std::uint32_t i = 0; (tree.used({level, block}) >> i & 1U) != 0; ++i) {
        sum += half_area(tree.block({level, block}).box(i));
      }
    }
  }
  return sum / half_area(tree.box());
}

TEST(PackedTree, PutsWhatIsNearTogether) {
  std::mt19937 random(kSeed);
  const auto boxes = random_boxes(random, 4096);
  CurveOrder curve;
  curve.sort(boxes);
  PackedTree tree;
  tree.build(boxes, curve.order());
  EXPECT_LT(surface(tree), 0.1 * (4096.0 / 8));
}

/// Rooms full of things, with a street of small things between them.
std::vector<Aabb> town(std::mt19937& random, std::size_t count) {
  std::vector<Aabb> boxes;
  while (boxes.size() < count) {
    const bool is_inside = boxes.size() % 5 != 0;
    const double west = 33 * std::floor(uniform(random, 0, 3)), south = 33 * std::floor(uniform(random, 0, 3));
    const double x = west + uniform(random, is_inside ? 7 : 0, is_inside ? 31 : 6), y = south + uniform(random, 7, 31);
    const double z = uniform(random, 0, is_inside ? 20 : 2), size = uniform(random, 0.1, is_inside ? 2 : 1);
    boxes.push_back({{x, y, z}, {x + size, y + size, z + size}});
  }
  return boxes;
}

TEST(SplitOrder, MakesABetterTreeThanTheCurve) {
  std::mt19937 random(kSeed);
  CurveOrder curve;
  SplitOrder split;
  PackedTree by_curve, by_splits;
  for (const std::size_t count : {100U, 512U, 1000U, 1024U}) {
    const auto boxes = town(random, count);
    curve.sort(boxes);
    split.sort(boxes);
    by_curve.build(boxes, curve.order());
    by_splits.build(boxes, split.order());
    EXPECT_LT(surface(by_splits), 0.9 * surface(by_curve)) << count << " boxes";
  }
}

TEST(SplitOrder, HasEachBoxOnce) {
  std::mt19937 random(kSeed);
  SplitOrder split;
  for (const std::size_t count : {0U, 1U, 7U, 8U, 9U, 63U, 64U, 65U, 100U, 513U, 1024U, 5000U, 2U}) {
    split.sort(random_boxes(random, count));
    std::vector<std::uint32_t> order(split.order().begin(), split.order().end());
    ASSERT_EQ(order.size(), count);
    std::ranges::sort(order);
    for (std::uint32_t i = 0; i < count; ++i) ASSERT_EQ(order[i], i);
  }
}

TEST(SplitOrder, TakesBoxesOfAnySizeAndPlace) {
  SplitOrder split;
  // All alike; far apart, so that areas are infinite in floats; nearer than a float can divide by.
  for (const double step : {0.0, 0x1p90, 0x1p-130}) {
    std::vector<Aabb> boxes;
    for (int i = 0; i < 100; ++i) boxes.push_back({{i * step, -i * step, 0}, {(i + 1) * step, 0, step}});
    split.sort(boxes);
    std::vector<std::uint32_t> order(split.order().begin(), split.order().end());
    std::ranges::sort(order);
    for (std::uint32_t i = 0; i < boxes.size(); ++i) ASSERT_EQ(order[i], i) << step;
  }
}

TEST(SplitOrder, KeepsItsMemory) {
  std::mt19937 random(kSeed);
  SplitOrder split;
  split.sort(random_boxes(random, 1000));
  const std::size_t bytes = split.bytes();
  split.sort(random_boxes(random, 900));
  split.sort(town(random, 1000));
  EXPECT_EQ(split.bytes(), bytes);
}

}  // namespace packed_tree_test
