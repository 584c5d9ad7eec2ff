// SPDX-License-Identifier: MIT
#include "model/node_blocks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/part_checks.h"
#include "model/bounds.h"
#include "model/part_list.h"

namespace occlude::culler {
namespace {

static_assert(sizeof(NodeBlock) == offsetof(NodeBlock, unused) + sizeof(NodeBlock::unused));

using Bits = NodeBlock::Bits;

Bits bit(std::uint32_t i) { return static_cast<Bits>(1U << i); }

/// How a tree is divided into blocks, so that a descent visits few. The children of each node are in the block of the node
/// or in one of their own below it. A block of its own is visited where the planes of views and shadows cross the node above
/// it, which is taken to be as often as random planes do. Of all divisions this one has the least sum.
class BlockPartition {
 public:
  /// The nodes of a block whose children are in it too.
  static constexpr std::size_t kParents = NodeBlock::kMostParents;

  explicit BlockPartition(std::span<const HierarchyNode> nodes) : nodes_(nodes), visits_(nodes.size()) {
    const double all = total_width(nodes[0].box), scale = all > 0 ? 1 / all : 0;
    for (auto node = static_cast<std::uint32_t>(nodes.size()); node-- > 0;) {  // children before their parents
      if (nodes[node].is_leaf()) continue;
      Visits& visits = visits_[node];
      visits[0] = static_cast<float>(scale * total_width(nodes[node].box)) + shared(node, kParents).visits;
      for (std::size_t parents = 1; parents <= kParents; ++parents) {
        visits[parents] = std::min(visits[0], shared(node, parents - 1).visits);
      }
    }
  }

  /// Numbers of parents among the nodes that begin with the left and the right child of a node, and how often blocks below
  /// are visited then.
  struct Share {
    std::size_t left, right;
    float visits;
  };
  /// How so many parents are best shared, where the children of the node are in one block.
  [[nodiscard]] Share shared(std::uint32_t node, std::size_t parents) const {
    const Visits &left = visits_[node + 1], &right = visits_[nodes_[node].right];
    Share best{0, parents, left[0] + right[parents]};
    for (std::size_t i = 1; i <= parents; ++i) {
      const float visits = left[i] + right[parents - i];
      if (visits < best.visits) best = {i, parents - i, visits};
    }
    return best;
  }
  /// Whether the node is one of the parents, where it and what is below it may have so many.
  [[nodiscard]] bool is_parent(std::uint32_t node, std::size_t parents) const {
    return !nodes_[node].is_leaf() && parents > 0 && shared(node, parents - 1).visits <= visits_[node][0];
  }

 private:
  /// For each number of parents among a node and what is below it: how often blocks below the node are visited, at best.
  using Visits = std::array<float, kParents + 1>;

  std::span<const HierarchyNode> nodes_;
  std::vector<Visits> visits_;
};

/// The nodes of a block, in ascending order, which is depth-first.
class BlockNodes {
 public:
  BlockNodes(std::span<const HierarchyNode> nodes, const BlockPartition& partition, std::uint32_t above) : nodes_(nodes) {
    if (above == NodeBlock::kNone) {
      take(partition, 0, BlockPartition::kParents);
    } else {
      take_children(partition, above, BlockPartition::kParents);
    }
  }
  /// Those of a block that is full. REQUIRES: they ascend.
  BlockNodes(std::span<const HierarchyNode> nodes, std::span<const std::uint32_t> taken)
      : nodes_(nodes), size_(taken.size()) {
    std::ranges::copy(taken, node_.begin());
  }

  [[nodiscard]] std::span<const std::uint32_t> taken() const { return std::span(node_).first(size_); }
  [[nodiscard]] bool has(std::uint32_t node) const { return std::ranges::binary_search(taken(), node); }

 private:
  void take(const BlockPartition& partition, std::uint32_t node, std::size_t parents) {
    node_[size_++] = node;
    if (partition.is_parent(node, parents)) take_children(partition, node, parents - 1);
  }
  void take_children(const BlockPartition& partition, std::uint32_t node, std::size_t parents) {
    const BlockPartition::Share share = partition.shared(node, parents);
    take(partition, node + 1, share.left);
    take(partition, nodes_[node].right, share.right);
  }

  std::span<const HierarchyNode> nodes_;
  std::array<std::uint32_t, NodeBlock::kNodes> node_{};
  std::size_t size_ = 0;
};

NodeBlock made(const Hierarchy& hierarchy, const BlockNodes& chosen) {
  const auto nodes = hierarchy.nodes();
  const auto taken = chosen.taken();
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
    if (!chosen.has(taken[i] + 1)) {
      block.exits = static_cast<Bits>(block.exits | bit(i));
      continue;
    }
    NodeBlock::Parent& parent = block.parents[parents++];
    parent.i = static_cast<std::uint8_t>(i);
    for (const std::uint32_t child : {taken[i] + 1, node.right}) {
      const auto k = static_cast<std::uint32_t>(std::ranges::lower_bound(taken, child) - taken.begin());
      parent.children = static_cast<Bits>(parent.children | bit(k));
      block.subtree[i] = static_cast<Bits>(block.subtree[i] | block.subtree[k]);
      parent.below = static_cast<Bits>(parent.below | block.subtree[k]);
    }
  }
  std::ranges::reverse(std::span(block.parents).first(parents));
  block.roots = static_cast<Bits>(block.used & ~kernel::boxes_of(block.children_of(kernel::BoxBytes{block.used}), 0));
  return block;
}

/// Whether the block is made() of nodes of this tree. A node has both of its children in the block, or neither.
bool is_made(const NodeBlock& block, const Hierarchy& hierarchy) {
  const auto nodes = hierarchy.nodes();
  const auto size = static_cast<std::size_t>(std::popcount(block.used));
  const auto taken = std::span(block.node).first(size);
  if (size == 0 || block.used != (1U << size) - 1 || !are_ascending_below(taken, nodes.size())) return false;
  const BlockNodes chosen(nodes, taken);
  const auto is_divided = [&](std::uint32_t i) {
    return !nodes[i].is_leaf() && chosen.has(i + 1) != chosen.has(nodes[i].right);
  };
  if (std::ranges::any_of(taken, is_divided)) return false;
  NodeBlock expected = made(hierarchy, chosen);
  expected.below = block.below;
  return std::memcmp(&expected, &block, sizeof block) == 0;  // NOLINT: doubles must have the same bits
}

/// Whether what is below each node of the block, in another block, are the children of the node. REQUIRES: is_made() of all.
bool are_linked(const NodeBlock& block, std::span<const NodeBlock> blocks, std::span<const HierarchyNode> nodes) {
  for (std::size_t i = 0; i < NodeBlock::kNodes; ++i) {
    const std::uint32_t below = block.below[i];
    if ((block.exits >> i & 1U) == 0) {
      if (below != NodeBlock::kNone) return false;
      continue;
    }
    if (below >= blocks.size() || std::popcount(blocks[below].roots) != 2) return false;
    const std::array<std::uint32_t, 2> children{block.node[i] + 1, nodes[block.node[i]].right};
    std::size_t found = 0;
    for (std::size_t k = 0; k < NodeBlock::kNodes; ++k) {
      const bool is_root = (blocks[below].roots >> k & 1U) != 0;
      if (is_root && blocks[below].node[k] == children[found]) ++found;
      if (found == children.size()) break;
    }
    if (found != children.size()) return false;
  }
  return true;
}

}  // namespace

NodeBlocks::NodeBlocks(const Hierarchy& hierarchy, const Checkpoint& checkpoint) {
  const auto nodes = hierarchy.nodes();
  const BlockPartition partition(nodes);
  std::vector<NodeBlock> blocks;
  // Depth-first, as the traversal reads them. A block that is still to be made is below node i of a block.
  struct Pending {
    std::uint32_t above, block, i;
  };
  std::vector<Pending> pending{{NodeBlock::kNone, 0, 0}};
  while (!pending.empty()) {
    checkpoint.at(blocks.size());
    const Pending at = pending.back();
    pending.pop_back();
    const BlockNodes chosen(nodes, partition, at.above);
    const auto index = static_cast<std::uint32_t>(blocks.size());
    if (at.above != NodeBlock::kNone) blocks[at.block].below[at.i] = index;
    blocks.push_back(made(hierarchy, chosen));
    const auto taken = chosen.taken();
    for (auto i = static_cast<std::uint32_t>(taken.size()); i-- > 0;) {
      if ((blocks[index].exits >> i & 1U) != 0) pending.push_back({taken[i], index, i});
    }
  }
  blocks.shrink_to_fit();
  blocks_ = std::move(blocks);
}

void NodeBlocks::append_parts(PartWriter& parts) const { parts.put(kPart, blocks_); }

NodeBlocks NodeBlocks::from_parts(const PartReader& parts, const Hierarchy& hierarchy, const Checkpoint& checkpoint) {
  NodeBlocks result;
  result.blocks_ = parts.get<NodeBlock>(kPart);
  const std::span blocks(result.blocks_);
  const auto is_block = [&](std::size_t i) { return is_made(blocks[i], hierarchy); };
  const auto is_linked = [&](std::size_t i) { return are_linked(blocks[i], blocks, hierarchy.nodes()); };
  if (blocks.empty() || !are_all(blocks.size(), is_block, checkpoint) || !are_all(blocks.size(), is_linked, checkpoint) ||
      blocks[0].node[0] != 0 || blocks[0].roots != 1) {
    refuse_part(kPart, "the blocks are not of this tree");
  }
  return result;
}

}  // namespace occlude::culler
