// SPDX-License-Identifier: MIT
// The descent of a tree of blocks that culls by the view and by what a cover buffer has closed, eight boxes at a time.
//
// Where what is seen closes pixels for what lies behind it, the descent goes from front to back. Nothing hides itself,
// because a box is never strictly beyond what it holds.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "base/each_bit.h"
#include "cover/cover_buffer.h"
#include "cover/projected_boxes.h"
#include "descent/block_descent.h"
#include "descent/view_descent.h"
#include "model/block_tree.h"
#include "model/hierarchy_blocks.h"
#include "occlude/culler/cull_result.h"
#include "occlude/kernel/box_block.h"

namespace occlude::culler {

/// A block as a descent has tested it.
template <class Boxes>
struct TestedBlock {
  const TreeBlock& block;
  Boxes boxes;             ///< of the block, where they stand
  ProjectedBoxes seen;     ///< in the picture. Nothing is known of them if none is `left`
  kernel::BoxBits left;    ///< those that take part and are not culled
  std::size_t groups = 0;  ///< how many had been drawn when they were found not to be hidden
  std::array<std::uint32_t, TreeBlock::kNodes> straddled_planes;  ///< of each box, a bit for each plane that may cross it

  TestedBlock(const TreeBlock& tested, Boxes&& stand, kernel::BoxBits asked, std::uint32_t planes)
      : block(tested), boxes(std::forward<Boxes>(stand)), left(asked) {
    straddled_planes.fill(planes);
  }
};

/// What is known above a block.
struct NodeState {
  std::uint32_t straddled_planes;  ///< a bit for each plane that may cross the node
  bool is_few;                     ///< whether it has few items, or is below a node that has
};

/// What nodes say, unless they say otherwise: all take part, where they are, and nothing is to be done beside them.
struct StandingNodes {
  static const kernel::BoxBlock& boxes(const TreeBlock& block) { return block.boxes; }
  static kernel::BoxBits asked(const TreeBlock& block) { return block.used; }
  static bool is_few(const ItemRange& items) { return items.count <= kFewItems; }
  static void prefetch(const ItemRange&) {}
  static void join() {}
};

/// `nodes` says what the tree holds:
///  - boxes(block): its kernel::BoxBlock, or a reference to it;
///  - asked(block): those that take part; the others are not heard of again;
///  - relations(block, boxes, asked): of the planes of the view and the nodes, as kernel::relations();
///  - prefetch(items): a hint that asked() comes for a block of these;
///  - cull(block, i, culled): called for each node that is culled when it is tested; Culled::node is not set;
///  - hide(boxes, hidden), of nodes that are to know where nodes are hidden when they are tested;
///  - decide(tested, i): called for each node that is left, when its turn comes. Returns whether to go below it, which is
///    false for a leaf;
///  - is_few(items): whether what is below a node of these items can be visited in any order;
///  - spend(work) and leave(block, straddled_planes), of nodes that have a budget: whether so many nodes may be asked; if
///    not, leave() is called, and the descent does not visit the block;
///  - join(): called after each leaf and each subtree of few items, unless it is below such a subtree.
template <class Nodes>
class CoverDescent {
 public:
  CoverDescent(const BlockTree& tree, const CoverBuffer& buffer, CullStats& stats, Nodes& nodes)
      : tree_(tree), buffer_(buffer), stats_(stats), nodes_(nodes) {}

  /// Descends from the first block, whose nodes `straddled_planes` has a bit for each plane that may cross.
  void run(std::uint32_t straddled_planes) {
    if (tree_.empty()) return;
    const bool is_few = nodes_.is_few(tree_.items());
    BlockDescent(tree_, *this).visit(0, {straddled_planes, is_few});
    if (is_few) nodes_.join();
  }
  /// The same from a block with few items.
  void run_few(std::uint32_t block, std::uint32_t straddled_planes) {
    BlockDescent(tree_, *this).visit(block, {straddled_planes, true});
    nodes_.join();
  }

  using Tested = TestedBlock<decltype(std::declval<const Nodes&>().boxes(std::declval<const TreeBlock&>()))>;
  /// The nodes of a block, those that are culled told to `nodes`. It enters none.
  [[nodiscard]] Tested test(const TreeBlock& block, std::uint32_t straddled_planes) {
    Tested tested(block, nodes_.boxes(block), nodes_.asked(block), straddled_planes);
    stats_.nodes_visited += kernel::count(tested.left);
    if (straddled_planes != 0 && tested.left != 0) keep_in_view(tested, straddled_planes);
    if (tested.left == 0) return tested;
    tested.seen.project(buffer_.box_picture(), tested.boxes);
    tested.groups = stats_.cover_groups;
    stats_.cover_tests += kernel::count(tested.left);
    const Bits hidden = buffer_.hidden(tested.seen, tested.left);
    if constexpr (requires { nodes_.hide(tested.seen, hidden); }) nodes_.hide(tested.seen, hidden);
    cull(tested, hidden, {0, Culled::By::cover});
    tested.left = static_cast<Bits>(tested.left & ~hidden);
    return tested;
  }

  /// For ways down the tree.
  using State = NodeState;
  template <class Enter>
  void visit(const TreeBlock& block, const State& above, const Enter& enter) {
    if constexpr (requires { nodes_.leave(block, 0U); }) {
      if (!nodes_.spend(kernel::count(block.used))) return nodes_.leave(block, above.straddled_planes);
    }
    const Tested tested = test(block, above.straddled_planes);
    if (above.is_few) {
      visit_in_any_order(tested, enter);
    } else {
      visit_in_order(tested, enter);
    }
  }

 private:
  using Bits = kernel::BoxBits;

  /// Nearest first.
  template <class Enter>
  void visit_in_order(const Tested& tested, const Enter& enter) {
    std::array<std::uint8_t, TreeBlock::kNodes> order{};
    std::size_t size = 0;
    for_each_bit(tested.left, [&](std::uint32_t i) {
      tree_.prefetch(tested.block.below[i]);
      std::size_t k = size++;
      for (; k > 0 && tested.seen.distance[order[k - 1]] > tested.seen.distance[i]; --k) order[k] = order[k - 1];
      order[k] = static_cast<std::uint8_t>(i);
    });
    for (const std::uint8_t i : std::span(order).first(size)) {
      const bool is_few = tested.block.is_leaf(i) || nodes_.is_few(tested.block.items(i));
      if (nodes_.decide(tested, i)) enter(i, State{tested.straddled_planes[i], is_few});
      if (is_few) nodes_.join();
    }
  }

  /// Decides about all nodes first, so that memory has time to fetch what is below.
  template <class Enter>
  void visit_in_any_order(const Tested& tested, const Enter& enter) {
    Bits entered = 0;
    for_each_bit(tested.left, [&](std::uint32_t i) {
      if (!nodes_.decide(tested, i)) return;
      entered = static_cast<Bits>(entered | 1U << i);
      tree_.prefetch(tested.block.below[i]);
      nodes_.prefetch(tested.block.items(i));
    });
    for_each_bit(entered, [&](std::uint32_t i) { enter(i, State{tested.straddled_planes[i], true}); });
  }

  /// Culls the nodes that are out of view.
  void keep_in_view(Tested& tested, std::uint32_t straddled_planes) {
    stats_.view_tests += kernel::count(tested.left) * static_cast<std::size_t>(std::popcount(straddled_planes));
    culler::keep_in_view(
        tested.left, tested.straddled_planes, straddled_planes,
        [&](kernel::BoxBytes asked) { return nodes_.relations(tested.block, tested.boxes, asked); },
        [&](Bits nodes, const Culled& culled) { cull(tested, nodes, culled); });
  }

  void cull(const Tested& tested, Bits nodes, const Culled& culled) {
    for_each_bit(nodes, [&](std::uint32_t i) { nodes_.cull(tested.block, i, culled); });
  }

  const BlockTree tree_;
  const CoverBuffer& buffer_;
  CullStats& stats_;
  Nodes& nodes_;
};

}  // namespace occlude::culler
