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

/// Expects that each box of a block is exactly the box around its items, and that the items follow each other.
void expect_sound(const PackedTree& tree, std::uint32_t at, const ItemRange& items) {
  const TreeBlock& block = tree.tree()[at];
  EXPECT_EQ(block.used, (1U << block.size()) - 1) << "the first ones are used";
  EXPECT_EQ(block.items().first, items.first);
  EXPECT_EQ(block.items().count, items.count);
  for (std::size_t i = 0; i < block.size(); ++i) {
    Aabb box = empty_box();
    for (std::uint32_t item = block.begin[i]; item < block.begin[i + 1]; ++item) grow(box, tree.item(item));
    EXPECT_EQ(block.boxes.box(i), box) << "block " << at << ", box " << i;
    if (block.is_leaf(i)) {
      EXPECT_EQ(block.count(i), 1U);
      EXPECT_EQ(block.below[i], TreeBlock::kNone);
    } else {
      ASSERT_GT(block.below[i], at);
      expect_sound(tree, block.below[i], block.items(i));
    }
  }
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
    expect_sound(tree, 0, {0, static_cast<std::uint32_t>(count)});
    ASSERT_EQ(tree.size(), count);
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
double surface(const PackedTree& packed) {
  const BlockTree tree = packed.tree();
  double sum = 0;
  for (std::uint32_t at = 0; at < tree.size(); ++at) {
    for (std::size_t i = 0; i < tree[at].size(); ++i) {
      if (!tree[at].is_leaf(i)) sum += half_area(tree[at].boxes.box(i));
    }
  }
  return sum / half_area(packed.box());
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

TEST(CurveOrder, HasRunsOfBoxesThatAreNear) {
  std::mt19937 random(kSeed);
  CurveOrder curve;
  for (const std::size_t count : {0U, 1U, 99U, 100U, 101U, 5000U}) {
    const auto boxes = random_boxes(random, count);
    curve.sort(boxes);
    std::uint32_t next = 0;
    double surfaces = 0;
    const auto runs = curve.runs(100);
    for (const auto& [first, size] : runs) {
      EXPECT_EQ(first, next);
      EXPECT_GT(size, 0U);
      EXPECT_LE(size, 100U);
      Aabb box = empty_box();
      for (const std::uint32_t i : curve.order().subspan(first, size)) grow(box, boxes[i]);
      surfaces += half_area(box);
      next = first + size;
    }
    EXPECT_EQ(next, count);
    if (count < 5000) continue;
    EXPECT_LT(surfaces, 0.2 * half_area({{-100, -100, 0}, {101, 101, 101}}) * static_cast<double>(runs.size()));
  }
}

TEST(CurveOrder, HasHalvesWhereAllIsAtOnePlace) {
  const std::vector<Aabb> boxes(1024, Aabb{{1, 1, 1}, {2, 2, 2}});
  CurveOrder curve;
  curve.sort(boxes);
  const auto runs = curve.runs(1);
  EXPECT_EQ(runs.size(), 1024U);
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
