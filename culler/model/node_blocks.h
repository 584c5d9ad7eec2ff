// SPDX-License-Identifier: MIT
// The nodes of a hierarchy in blocks of up to eight, for tests of eight boxes at once.
#pragma once

#include <hwy/cache_control.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "occlude/culler/array.h"
#include "occlude/culler/checkpoint.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/kernel/box_block.h"

namespace occlude::culler {

/// Probes are not followed into subtrees of this many polygons or fewer, because what they hide there is little.
inline constexpr std::uint32_t kProbed = 64;

/// A part of the tree: nodes that hang together, and are numbered depth-first. Every node is in one block: the root in the
/// first, any other below that of its parent or in the same.
struct alignas(64) NodeBlock {
  static constexpr std::size_t kNodes = kernel::BoxBlock::kBoxes;
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  using Bits = kernel::BoxBits;

  /// A node with children in this block.
  struct Parent {
    std::uint8_t i = 0;
    Bits children = 0;
    Bits below = 0;  ///< children, and what is below them in this block
  };
  /// With the children of three nodes and two of another block's, or with the root, a block is full.
  static constexpr std::size_t kMostParents = 3;

  kernel::BoxBlock boxes;
  std::array<std::uint32_t, kNodes> node{}, first{}, count{};  ///< of each, its index in the tree, and its items
  std::array<std::uint32_t, kNodes> below{};                   ///< the block that its children are in, or kNone
  std::array<Bits, kNodes> subtree{};                          ///< itself and what is below it in this block
  std::array<Parent, kMostParents> parents{};                  ///< ascending; the others have no children
  Bits used = 0;                                               ///< the nodes that there are
  Bits roots = 0;                                              ///< those whose parent is in another block
  Bits exits = 0;                                              ///< those with children in another block
  Bits probed = 0;                                             ///< those with more than kProbed items
  Bits oriented = 0;                                           ///< those whose volume is not the box
  std::array<std::byte, 42> unused{};                          ///< so that every byte of a block has a value

  /// The nodes of the block whose parent is one of these, for each of eight questions.
  [[nodiscard]] kernel::BoxBytes children_of(kernel::BoxBytes nodes) const {
    kernel::BoxBytes found = 0;
    for (const Parent& parent : parents) found |= (nodes >> parent.i & kernel::for_all(1)) * parent.children;
    return found;
  }
  /// These nodes and those below them in the block.
  [[nodiscard]] std::uint32_t with_below(std::uint32_t nodes) const {
    std::uint32_t found = nodes;
    for (const Parent& parent : parents) found |= (0U - (nodes >> parent.i & 1U)) & parent.below;
    return found;
  }
  /// The nodes that a descent visits which enters these: the roots, and the children of nodes that it visits and enters.
  [[nodiscard]] std::uint32_t visited(std::uint32_t entered) const {
    std::uint32_t missed = 0;
    for (const Parent& parent : parents) missed |= ((entered >> parent.i & 1U) - 1U) & parent.below;
    return used & ~missed;
  }
};

class PartReader;
class PartWriter;

/// The blocks of a tree, in the order in which a descent enters them.
class NodeBlocks {
 public:
  static constexpr std::string_view kPart = "node blocks";

  NodeBlocks() = default;
  /// What `checkpoint` throws is thrown on.
  explicit NodeBlocks(const Hierarchy& hierarchy, const Checkpoint& checkpoint = {});
  /// For Culler::parts().
  void append_parts(PartWriter& parts) const;
  /// The blocks with these parts. Throws std::invalid_argument unless a descent from the first of them visits the nodes of
  /// this tree, each once, with their boxes.
  [[nodiscard]] static NodeBlocks from_parts(const PartReader& parts, const Hierarchy& hierarchy,
                                             const Checkpoint& checkpoint = {});

  [[nodiscard]] const NodeBlock& operator[](std::uint32_t i) const { return blocks_[i]; }
  [[nodiscard]] std::size_t size() const { return blocks_.size(); }
  /// A hint that block i comes.
  void prefetch(std::uint32_t i) const { prefetch_bytes(&blocks_[i], sizeof(NodeBlock)); }
  /// A hint that the boxes of the block after this one in memory come. There need not be one.
  static void prefetch_after(const NodeBlock& block) { prefetch_bytes(&block + 1, sizeof(NodeBlock::boxes)); }

 private:
  static void prefetch_bytes(const NodeBlock* block, std::size_t bytes) {
    const auto begin = reinterpret_cast<std::uintptr_t>(block);  // there may be no block
    for (std::size_t byte = 0; byte < bytes; byte += alignof(NodeBlock)) {
      hwy::Prefetch(reinterpret_cast<const std::byte*>(begin + byte));
    }
  }

  Array<NodeBlock> blocks_;
};

}  // namespace occlude::culler
