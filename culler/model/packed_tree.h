// SPDX-License-Identifier: MIT
// A tree of blocks of eight boxes, built in linear time, for what is tested eight boxes at once.
#pragma once

#include <hwy/cache_control.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "model/bounds.h"
#include "model/curve_order.h"
#include "occlude/kernel/box_block.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// A packed R-tree (Roussopoulos and Leifker 1985). Its items are sorted along a curve. Level 0 holds their boxes in blocks
/// of eight; each level above holds the boxes of the blocks below. All blocks are full but the last of each level, and the
/// last level is one block. Building a tree over no more boxes than before allocates nothing.
class PackedTree {
 public:
  static constexpr std::uint32_t kWidth = kernel::BoxBlock::kBoxes;

  /// A block: the level, and its number there.
  struct At {
    std::uint32_t level, block;
  };
  /// Items, in the order of the tree.
  struct Items {
    std::uint32_t first, count;
  };

  /// Builds a tree of these boxes, whose order was found. REQUIRES: finite boxes.
  void build(std::span<const kernel::Aabb> boxes, std::span<const std::uint32_t> order);
  void clear();

  [[nodiscard]] std::uint32_t size() const { return empty() ? 0 : boxes_[0]; }
  [[nodiscard]] bool empty() const { return levels_ == 0; }
  /// The block that all others are below. REQUIRES: not empty.
  [[nodiscard]] At root() const { return {levels_ - 1, 0}; }
  [[nodiscard]] static At below(const At& at, std::uint32_t i) { return {at.level - 1, kWidth * at.block + i}; }
  [[nodiscard]] const kernel::BoxBlock& block(const At& at) const { return blocks_[begin_[at.level] + at.block]; }
  /// A hint that block(at) comes.
  void prefetch(const At& at) const {
    const kernel::BoxBlock& block = this->block(at);
    for (const auto* rows : {&block.min, &block.max}) {
      for (const kernel::BoxBlock::Row& row : *rows) hwy::Prefetch(row.data());
    }
  }
  /// The boxes that a block has.
  [[nodiscard]] kernel::BoxBits used(const At& at) const {
    return static_cast<kernel::BoxBits>((1U << std::min(kWidth, boxes_[at.level] - kWidth * at.block)) - 1);
  }
  /// What box i of a block holds.
  [[nodiscard]] Items items(const At& at, std::uint32_t i) const {
    const std::uint32_t shift = kShift * at.level, first = (kWidth * at.block + i) << shift;
    return {first, std::min(std::uint32_t{1} << shift, boxes_[0] - first)};
  }
  [[nodiscard]] kernel::Aabb item(std::uint32_t i) const { return blocks_[i / kWidth].box(i % kWidth); }
  /// The box around all; empty_box() if there are none.
  [[nodiscard]] const kernel::Aabb& box() const { return box_; }
  /// The bytes of memory that it holds.
  [[nodiscard]] std::size_t bytes() const { return blocks_.capacity() * sizeof(kernel::BoxBlock); }

 private:
  static constexpr std::uint32_t kShift = 3;
  static_assert(kWidth == 1U << kShift);
  /// Enough for 2^32 items.
  static constexpr std::size_t kMostLevels = 11;

  std::vector<kernel::BoxBlock> blocks_;                      ///< level after level, of the items first
  std::array<std::uint32_t, kMostLevels> begin_{}, boxes_{};  ///< of each level: its first block, and how many boxes it has
  std::uint32_t levels_ = 0;
  kernel::Aabb box_ = empty_box();
};

}  // namespace occlude::culler
