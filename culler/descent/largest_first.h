// SPDX-License-Identifier: MIT
// Another way down a tree of blocks: level by level from the largest subtrees on, for tests whose order does not matter and
// of which the last may be left out.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/block_tree.h"

namespace occlude::culler {

/// The blocks that are to be visited. `State` is that of the tests, which are as BlockDescent has them.
template <class State>
class LargestFirst {
 public:
  /// Forgets all blocks, and reserves memory for those of the tree.
  void begin(const BlockTree& tree) {
    blocks_.clear();
    blocks_.reserve(tree.size());
  }
  void push(const TreeBlock& block, const State& state) { blocks_.push_back({&block, state}); }

  /// Visits the blocks and those below them.
  template <class Tests>
  void visit(const BlockTree& tree, Tests& tests) {
    std::ranges::sort(blocks_, [](const Left& a, const Left& b) {
      const std::uint32_t of_a = a.block->items().count, of_b = b.block->items().count;
      return of_a != of_b ? of_a > of_b : a.block < b.block;
    });
    for (std::size_t next = 0; next < blocks_.size(); ++next) {
      const Left left = blocks_[next];
      tests.visit(*left.block, left.state, [&](std::uint32_t i, const State& below) {
        tree.prefetch(left.block->below[i]);
        push(tree[left.block->below[i]], below);
      });
    }
    blocks_.clear();
  }

 private:
  struct Left {
    const TreeBlock* block;
    State state;
  };

  std::vector<Left> blocks_;
};

}  // namespace occlude::culler
