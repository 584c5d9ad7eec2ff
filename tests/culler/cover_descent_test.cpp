// SPDX-License-Identifier: MIT
// What a descent finds worth drawing into the coarse picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <vector>

#include "base/radix_sort.h"
#include "cover/opening.h"
#include "cover/worth_drawing.h"
#include "model/hierarchy_blocks.h"
#include "occlude/culler/camera.h"
#include "scenes.h"

namespace cover_descent_test {

using namespace occlude;
using namespace occlude::culler;

/// Strips above each other, less than a pixel high and one to forty pixels long.
Hierarchy strips() {
  PolygonSoup soup;
  for (int i = 1; i <= 40; ++i) {
    const double z = 3 * i - 60 + 0.3;
    const auto first = static_cast<std::uint32_t>(soup.vertices.size());
    soup.vertices.insert(soup.vertices.end(), {{10, 0.5, z}, {10, i, z}, {10, i, z + 0.4}, {10, 0.5, z + 0.4}});
    soup.add_polygon(std::array{first, first + 1, first + 2, first + 3});
  }
  return Hierarchy::build(soup, {.leaf_size = 1});
}

class WorthDrawing : public testing::Test {
 protected:
  WorthDrawing() {
    Camera camera;
    camera.projection = Projection::orthographic;
    camera.height = 128;
    camera.aspect = 2;
    buffer_.begin(FrameView(camera, 100), 256 + 64, 128 + 64, 0);  // a pixel is a unit
  }

  /// Asks of each leaf what the nodes of models and of occluders ask.
  struct Nodes : StandingNodes {
    const CoverBuffer& buffer;
    std::size_t triangles;
    int least;
    std::map<std::uint32_t, bool>& leaves;

    static kernel::BlockRelations relations(const TreeBlock&, const kernel::BoxBlock&, kernel::BoxBytes) { return {}; }
    static void cull(const TreeBlock&, std::uint32_t, const Culled&) { ADD_FAILURE() << "nothing is hidden"; }
    template <class Boxes>
    bool decide(const TestedBlock<Boxes>& tested, std::uint32_t i) {
      if (!tested.block.is_leaf(i)) return true;
      const int worth = worth_closing(least, triangles);
      leaves[tested.block.node[i]] = Opening(buffer, tested, i, 0, worth).open >= worth;
      return false;
    }
  };

  /// The leaves that a descent passes on once so many triangles are drawn, and whether each is worth drawing.
  [[nodiscard]] std::map<std::uint32_t, bool> found(int least, std::size_t triangles) const {
    std::map<std::uint32_t, bool> leaves;
    CullStats stats;
    Nodes nodes{{}, buffer_, triangles, least, leaves};
    const HierarchyBlocks blocks(tree_);
    CoverDescent(blocks.tree(), buffer_, stats, nodes).run(0);
    return leaves;
  }
  [[nodiscard]] int open(std::uint32_t leaf) const { return buffer_.open(buffer_.footprint(tree_.nodes()[leaf].box), 1000); }
  [[nodiscard]] std::size_t leaves() const {
    return static_cast<std::size_t>(std::ranges::count_if(tree_.nodes(), [](const auto& node) { return node.is_leaf(); }));
  }

  CoverBuffer buffer_;
  Hierarchy tree_ = strips();
};

/// Else a limit that is wrong by one would not be noticed.
TEST_F(WorthDrawing, IsAskedOfEveryNumberOfPixels) {
  std::set<int> numbers;
  for (const auto& [leaf, is_worth] : found(kWorthOfLeaf, 0)) numbers.insert(open(leaf));
  for (int n = 7; n <= 25; ++n) EXPECT_TRUE(numbers.contains(n)) << n;
}

TEST_F(WorthDrawing, IsWhatEnoughPixelsAreOpenFor) {
  for (const auto& [triangles, least] : std::map<std::size_t, int>{
           {0, 8}, {4096, 8}, {4607, 8}, {4608, 9}, {8192, 16}, {12288, 24}, {1U << 20U, 24}, {~std::size_t{0}, 24}}) {
    const auto seen = found(kWorthOfLeaf, triangles);
    EXPECT_EQ(seen.size(), leaves()) << "all are seen";
    for (const auto& [leaf, is_worth] : seen) EXPECT_EQ(is_worth, open(leaf) >= least) << triangles << ", leaf " << leaf;
  }
}

TEST_F(WorthDrawing, IsLessAmongOccluders) {
  for (const auto& [triangles, least] : std::map<std::size_t, int>{{0, 12}, {4608, 12}, {8192, 16}, {12288, 24}}) {
    for (const auto& [leaf, is_worth] : found(kWorthOfOccluder, triangles)) {
      EXPECT_EQ(is_worth, open(leaf) >= least) << triangles << ", leaf " << leaf;
    }
  }
}

TEST(RadixSort, IsAStableSort) {
  struct Element {
    std::uint32_t key, number;
    bool operator==(const Element&) const = default;
  };
  constexpr std::uint32_t kSeed = 3;
  std::mt19937 random(kSeed);
  std::vector<Element> room;
  for (const std::uint64_t end : {1U, 2U, 2047U, 2048U, 2049U, 1U << 22U, (1U << 22U) + 1, 0xFFFFFFFFU}) {
    for (const std::uint32_t size : {0U, 1U, 2U, 1000U}) {
      std::vector<Element> values;
      for (std::uint32_t i = 0; i < size; ++i) values.push_back({static_cast<std::uint32_t>(random() % end), i});
      if (size > 1) values[1].key = static_cast<std::uint32_t>(end - 1);
      std::vector<Element> expected = values;
      std::ranges::stable_sort(expected, {}, &Element::key);
      radix_sort(values, room, end, &Element::key);
      EXPECT_EQ(values, expected) << size << " keys below " << end << ", seed " << kSeed;
    }
  }
}

}  // namespace cover_descent_test
