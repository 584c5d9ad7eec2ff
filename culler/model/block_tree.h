// SPDX-License-Identifier: MIT
// A tree of blocks of eight boxes, for tests of all of them at once.
#pragma once

#include <hwy/cache_control.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "occlude/kernel/box_block.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// Items of a tree, in its order.
struct ItemRange {
  std::uint32_t first = 0, count = 0;
};

/// Up to eight nodes of a tree, side by side: those that a node in the block above is divided into, in order. Together
/// they have its items. A leaf is not divided further.
struct alignas(64) TreeBlock {
  static constexpr std::size_t kNodes = kernel::BoxBlock::kBoxes;
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  using Bits = kernel::BoxBits;

  kernel::BoxBlock boxes;
  std::array<std::uint32_t, kNodes + 1> begin{};  ///< node i has items [begin[i], begin[i + 1])
  std::array<std::uint32_t, kNodes> node{};       ///< of each, its index in a hierarchy; 0 in a tree without one
  std::array<std::uint32_t, kNodes> below{};      ///< the block that it is divided in; kNone of a leaf
  Bits used = 0;                                  ///< the nodes that there are, the first ones
  Bits divided = 0;                               ///< those that are no leaves
  Bits oriented = 0;                              ///< those whose volume is not the box
  std::array<std::byte, 25> unused{};             ///< so that every byte of a block has a value

  TreeBlock() { below.fill(kNone); }

  /// Adds a leaf behind the nodes that there are. REQUIRES: fewer than kNodes; its items follow theirs.
  void add(const kernel::Aabb& box, const ItemRange& items) {
    const std::size_t i = size();
    boxes.set(i, box);
    if (i == 0) begin.fill(items.first);
    for (std::size_t k = i + 1; k < begin.size(); ++k) begin[k] = items.first + items.count;
    used = static_cast<Bits>(used | 1U << i);
  }
  /// Says where a node is divided.
  void divide(std::size_t i, std::uint32_t block) {
    below[i] = block;
    divided = static_cast<Bits>(divided | 1U << i);
  }

  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(std::bit_width(used)); }
  [[nodiscard]] std::uint32_t count(std::size_t i) const { return begin[i + 1] - begin[i]; }
  [[nodiscard]] ItemRange items(std::size_t i) const { return {begin[i], count(i)}; }
  /// Those of all nodes.
  [[nodiscard]] ItemRange items() const { return {begin[0], begin[kNodes] - begin[0]}; }
  [[nodiscard]] bool is_leaf(std::size_t i) const { return (divided >> i & 1U) == 0; }
};

/// The blocks of a tree, where they lie. The first one has the root, or what it is divided into, and every other is below
/// one before it.
class BlockTree {
 public:
  BlockTree() = default;
  explicit BlockTree(std::span<const TreeBlock> blocks) : blocks_(blocks) {}

  [[nodiscard]] const TreeBlock& operator[](std::uint32_t i) const { return blocks_[i]; }
  [[nodiscard]] std::size_t size() const { return blocks_.size(); }
  [[nodiscard]] bool empty() const { return blocks_.empty(); }
  /// All of them. REQUIRES: not empty.
  [[nodiscard]] ItemRange items() const { return blocks_[0].items(); }

  /// A hint that block i comes. There need not be one.
  void prefetch(std::uint32_t i) const { prefetch(i, sizeof(TreeBlock)); }
  /// A hint that the boxes of block i come. There need not be one.
  void prefetch_boxes(std::uint32_t i) const { prefetch(i, sizeof(TreeBlock::boxes)); }

 private:
  void prefetch(std::uint32_t i, std::size_t bytes) const {
    const auto begin = reinterpret_cast<std::uintptr_t>(blocks_.data()) + i * sizeof(TreeBlock);  // there may be no block
    for (std::size_t byte = 0; byte < bytes; byte += alignof(TreeBlock)) {
      hwy::Prefetch(reinterpret_cast<const std::byte*>(begin + byte));
    }
  }

  std::span<const TreeBlock> blocks_;
};

}  // namespace occlude::culler
