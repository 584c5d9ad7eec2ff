// SPDX-License-Identifier: MIT
// The nodes of a hierarchy in blocks of up to eight, for tests of eight boxes at once.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "occlude/culler/hierarchy.h"
#include "occlude/kernel/box_block.h"

namespace occlude::culler {

/// Calls visit(i) for each bit, in ascending order.
template <class Visit>
void for_each_bit(std::uint32_t bits, const Visit& visit) {
  for (; bits != 0; bits &= bits - 1) visit(static_cast<std::uint32_t>(std::countr_zero(bits)));
}

/// A part of the tree: nodes that hang together, and are numbered depth-first. Every node but the root is in one block,
/// below that of its parent or in the same; the root is the only node of the first block.
struct alignas(64) NodeBlock {
  static constexpr std::size_t kNodes = kernel::BoxBlock::kBoxes;
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  using Bits = kernel::BoxBits;

  kernel::BoxBlock boxes;
  std::array<std::uint32_t, kNodes> node{}, first{}, count{};  ///< of each, its index in the tree, and its items
  std::array<std::uint32_t, kNodes> below{};                   ///< the block that its children are in, or kNone
  std::array<Bits, kNodes> children{};                         ///< its children in this block
  std::array<Bits, kNodes> subtree{};                          ///< itself and what is below it in this block
  Bits used = 0;                                               ///< the nodes that there are
  Bits roots = 0;                                              ///< those whose parent is in another block
  Bits parents = 0;                                            ///< those with children in this block
  Bits oriented = 0;                                           ///< those whose volume is not the box

  [[nodiscard]] bool is_leaf(std::uint32_t i) const { return below[i] == kNone && children[i] == 0; }
  /// The nodes of the block whose parent is one of these.
  [[nodiscard]] Bits children_of(Bits nodes) const { return kernel::boxes_of(children_of(kernel::BoxBytes{nodes}), 0); }
  /// The same for each of eight questions.
  [[nodiscard]] kernel::BoxBytes children_of(kernel::BoxBytes nodes) const {
    kernel::BoxBytes found = 0;
    for_each_bit(parents, [&](std::uint32_t i) { found |= (nodes >> i & kernel::for_all(1)) * children[i]; });
    return found;
  }
};

/// The blocks of a tree, the first first. Copied with its owner.
class NodeBlocks {
 public:
  NodeBlocks() = default;
  explicit NodeBlocks(const Hierarchy& hierarchy);

  [[nodiscard]] const NodeBlock& operator[](std::uint32_t i) const { return blocks_[i]; }
  [[nodiscard]] std::size_t size() const { return blocks_.size(); }

 private:
  std::vector<NodeBlock> blocks_;
};

}  // namespace occlude::culler
