// SPDX-License-Identifier: MIT
// One way down a tree of blocks, for tests of any kind.
#pragma once

#include <cstdint>

#include "model/block_tree.h"

namespace occlude::culler {

/// `Tests` has a type State: what is known above a block, from which it follows for the nodes in it; and
/// visit(block, state, enter), which tests the nodes of a block, all at once, and then calls enter(i, below), in the order
/// that it chooses, for each node i that the descent is to go below, with what is known there. When enter() returns, all
/// that is below the node has been visited.
template <class Tests>
class BlockDescent {
 public:
  BlockDescent(const BlockTree& tree, Tests& tests) : tree_(tree), tests_(tests) {}

  /// Visits a block and those below it.
  void visit(std::uint32_t at, const typename Tests::State& state) {
    tree_.prefetch_boxes(at + 1);  // most often it is the first below this one, and is entered
    const TreeBlock& block = tree_[at];
    tests_.visit(block, state, [&](std::uint32_t i, const auto& below) { visit(block.below[i], below); });
  }

 private:
  const BlockTree& tree_;
  Tests& tests_;
};

}  // namespace occlude::culler
