// SPDX-License-Identifier: MIT
#include "node_blocks.h"

#include <algorithm>
#include <type_traits>

#include "bounds.h"

namespace occlude::culler {
namespace {

using Bits = NodeBlock::Bits;

Bits bit(std::uint32_t i) { return static_cast<Bits>(1U << i); }

/// The nodes of a block while it is filled, in ascending order, which is depth-first.
class Filling {
 public:
  Filling(std::span<const HierarchyNode> nodes, std::uint32_t above) : nodes_(nodes) {
    if (above == NodeBlock::kNone) {
      take(0);
    } else {
      take(above + 1);
      take(nodes[above].right);
    }
  }

  /// Takes the children of the largest nodes too, which are entered most often.
  void fill() {
    while (size_ + 2 <= NodeBlock::kNodes) {
      const std::uint32_t* largest = nullptr;
      for (const std::uint32_t& node : taken()) {
        if (nodes_[node].is_leaf() || has(node + 1)) continue;
        if (!largest || half_area(nodes_[node].box) > half_area(nodes_[*largest].box)) largest = &node;
      }
      if (!largest) return;
      const std::uint32_t parent = *largest;
      take(parent + 1);
      take(nodes_[parent].right);
    }
  }

  [[nodiscard]] std::span<const std::uint32_t> taken() const { return std::span(node_).first(size_); }
  [[nodiscard]] bool has(std::uint32_t node) const { return std::ranges::binary_search(taken(), node); }

 private:
  void take(std::uint32_t node) {
    node_[size_++] = node;
    std::ranges::sort(std::span(node_).first(size_));
  }

  std::span<const HierarchyNode> nodes_;
  std::array<std::uint32_t, NodeBlock::kNodes> node_{};
  std::size_t size_ = 0;
};

NodeBlock made(const Hierarchy& hierarchy, const Filling& filling) {
  const auto nodes = hierarchy.nodes();
  const auto taken = filling.taken();
  NodeBlock block;
  block.below.fill(NodeBlock::kNone);
  std::size_t parents = 0;
  for (std::uint32_t i = static_cast<std::uint32_t>(taken.size()); i-- > 0;) {
    const HierarchyNode& node = nodes[taken[i]];
    block.boxes.set(i, node.box);
    block.node[i] = taken[i];
    block.first[i] = node.first;
    block.count[i] = node.count;
    block.used = static_cast<Bits>(block.used | bit(i));
    if (node.count > kProbed) block.probed = static_cast<Bits>(block.probed | bit(i));
    block.subtree[i] = bit(i);
    const bool is_oriented = hierarchy.ask(
        taken[i], [](const auto& box) { return std::is_same_v<std::remove_cvref_t<decltype(box)>, kernel::Obb>; });
    if (is_oriented) block.oriented = static_cast<Bits>(block.oriented | bit(i));
    if (node.is_leaf()) continue;
    if (!filling.has(taken[i] + 1)) {
      block.exits = static_cast<Bits>(block.exits | bit(i));
      continue;
    }
    NodeBlock::Parent& parent = block.parents[parents++];
    parent.i = static_cast<std::uint8_t>(i);
    for (const std::uint32_t child : {taken[i] + 1, node.right}) {
      const auto k = static_cast<std::uint32_t>(std::ranges::lower_bound(taken, child) - taken.begin());
      parent.children = static_cast<Bits>(parent.children | bit(k));
      block.subtree[i] = static_cast<Bits>(block.subtree[i] | block.subtree[k]);
    }
  }
  std::ranges::reverse(std::span(block.parents).first(parents));
  block.roots = static_cast<Bits>(block.used & ~kernel::boxes_of(block.children_of(kernel::BoxBytes{block.used}), 0));
  return block;
}

}  // namespace

NodeBlocks::NodeBlocks(const Hierarchy& hierarchy, const Checkpoint& checkpoint) {
  const auto nodes = hierarchy.nodes();
  // Depth-first, as the traversal reads them. A block that is still to be made is below node i of a block.
  struct Pending {
    std::uint32_t above, block, i;
  };
  std::vector<Pending> pending{{NodeBlock::kNone, 0, 0}};
  while (!pending.empty()) {
    checkpoint.at(blocks_.size());
    const Pending at = pending.back();
    pending.pop_back();
    Filling filling(nodes, at.above);
    filling.fill();
    const auto index = static_cast<std::uint32_t>(blocks_.size());
    if (at.above != NodeBlock::kNone) blocks_[at.block].below[at.i] = index;
    blocks_.push_back(made(hierarchy, filling));
    const auto taken = filling.taken();
    for (auto i = static_cast<std::uint32_t>(taken.size()); i-- > 0;) {
      if ((blocks_[index].exits >> i & 1U) != 0) pending.push_back({taken[i], index, i});
    }
  }
  blocks_.shrink_to_fit();
}

}  // namespace occlude::culler
