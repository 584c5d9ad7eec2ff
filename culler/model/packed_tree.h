// SPDX-License-Identifier: MIT
// A tree of blocks over boxes in some order, built in linear time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "model/block_tree.h"
#include "model/bounds.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// A packed R-tree (Roussopoulos and Leifker 1985). The boxes of its items are in blocks of eight, in their order; those of
/// each eight blocks in the blocks of the level above. All blocks are full but the last of each level, and the first level
/// is one block. Building a tree over no more boxes than before allocates nothing.
class PackedTree {
 public:
  /// Builds a tree of these boxes in this order. REQUIRES: finite boxes.
  void build(std::span<const kernel::Aabb> boxes, std::span<const std::uint32_t> order);
  void clear();

  /// Each leaf is an item, with its number in the order.
  [[nodiscard]] BlockTree tree() const { return BlockTree(blocks_); }
  [[nodiscard]] std::uint32_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] kernel::Aabb item(std::uint32_t i) const {
    return blocks_[first_of_items_ + i / TreeBlock::kNodes].boxes.box(i % TreeBlock::kNodes);
  }
  /// The box around all; empty_box() if there are none.
  [[nodiscard]] const kernel::Aabb& box() const { return box_; }
  /// The bytes of memory that it holds.
  [[nodiscard]] std::size_t bytes() const { return blocks_.capacity() * sizeof(TreeBlock); }

 private:
  void build_level_above(std::size_t level, std::size_t below, std::size_t count);

  std::vector<TreeBlock> blocks_;   ///< level after level, that of the items last
  std::size_t first_of_items_ = 0;  ///< the first block of items
  std::uint32_t size_ = 0;
  kernel::Aabb box_ = empty_box();
};

}  // namespace occlude::culler
