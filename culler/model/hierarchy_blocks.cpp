// SPDX-License-Identifier: MIT
#include "model/hierarchy_blocks.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/part_checks.h"
#include "model/bounds.h"
#include "model/part_list.h"

namespace occlude::culler {
namespace {

static_assert(sizeof(TreeBlock) == offsetof(TreeBlock, unused) + sizeof(TreeBlock::unused));

/// How a binary tree is divided into blocks, so that a descent visits few. The block below a node is visited where the
/// planes of views and shadows cross the node, which is taken to be as often as random planes do. Of all divisions this one
/// has the least sum.
class BlockPartition {
 public:
  static constexpr std::size_t kMost = TreeBlock::kNodes;

  explicit BlockPartition(std::span<const HierarchyNode> nodes) : nodes_(nodes), visits_(nodes.size()) {
    const double all = total_width(nodes[0].box), scale = all > 0 ? 1 / all : 0;
    for (auto node = static_cast<std::uint32_t>(nodes.size()); node-- > 0;) {  // children before their parents
      if (nodes[node].is_leaf()) continue;
      Visits& visits = visits_[node];
      visits[0] = static_cast<float>(scale * total_width(nodes[node].box)) + shared(node, kMost).visits;
      for (std::size_t places = 2; places <= kMost; ++places) {
        visits[places - 1] = std::min(visits[0], shared(node, places).visits);
      }
    }
  }

  /// How many places of a block the left and the right child of a node may take, and how often blocks below them are visited
  /// then.
  struct Share {
    std::size_t left, right;
    float visits;
  };
  /// The best shares where the node may take so many places, two or more. REQUIRES: it is not a leaf.
  [[nodiscard]] Share shared(std::uint32_t node, std::size_t places) const {
    const std::uint32_t left = node + 1, right = nodes_[node].right;
    const std::size_t most_left = most_places(node, left), most_right = most_places(node, right);
    const auto share = [&](std::size_t i) -> Share {
      const std::size_t of_left = std::min(i, most_left), of_right = std::min(places - i, most_right);
      return {of_left, of_right, visits_[left][of_left - 1] + visits_[right][of_right - 1]};
    };
    Share best = share(places / 2);  // where all are alike, halves fill blocks best
    for (std::size_t i = 1; i < places; ++i) {
      if (const Share other = share(i); other.visits < best.visits) best = other;
    }
    return best;
  }
  /// Whether a node that may take so many places is divided in the block.
  [[nodiscard]] bool is_divided(std::uint32_t node, std::size_t places) const {
    return !nodes_[node].is_leaf() && places > 1 && shared(node, places).visits <= visits_[node][0];
  }

 private:
  /// For each number of places that a node may take in a block: how often blocks below it are visited, at best.
  using Visits = std::array<float, kMost>;

  /// How many places a child may take beside others: one, where a subtree of few items begins.
  [[nodiscard]] std::size_t most_places(std::uint32_t parent, std::uint32_t child) const {
    return nodes_[parent].count > kFewItems && nodes_[child].count <= kFewItems ? 1 : kMost;
  }

  std::span<const HierarchyNode> nodes_;
  std::vector<Visits> visits_;
};

/// What a node is divided into, in the order of the tree: a leaf, into itself.
class NodeFront {
 public:
  NodeFront(std::span<const HierarchyNode> nodes, const BlockPartition& partition, std::uint32_t node) : nodes_(nodes) {
    if (nodes[node].is_leaf()) {
      found_[size_++] = node;
    } else {
      divide(partition, node, BlockPartition::kMost);
    }
  }

  [[nodiscard]] std::span<const std::uint32_t> found() const { return std::span(found_).first(size_); }

 private:
  void divide(const BlockPartition& partition, std::uint32_t node, std::size_t places) {
    const BlockPartition::Share share = partition.shared(node, places);
    take(partition, node + 1, share.left);
    take(partition, nodes_[node].right, share.right);
  }
  void take(const BlockPartition& partition, std::uint32_t node, std::size_t places) {
    if (partition.is_divided(node, places)) {
      divide(partition, node, places);
    } else {
      found_[size_++] = node;
    }
  }

  std::span<const HierarchyNode> nodes_;
  std::array<std::uint32_t, TreeBlock::kNodes> found_{};
  std::size_t size_ = 0;
};

/// The block of these nodes, where nothing is known of what is below. REQUIRES: at most TreeBlock::kNodes.
TreeBlock block_of(const Hierarchy& hierarchy, std::span<const std::uint32_t> taken) {
  TreeBlock block;
  for (std::size_t i = 0; i < taken.size(); ++i) {
    const HierarchyNode& node = hierarchy.nodes()[taken[i]];
    block.add(node.box, {node.first, node.count});
    block.node[i] = taken[i];
    const bool is_oriented = hierarchy.ask(
        taken[i], [](const auto& box) { return std::is_same_v<std::remove_cvref_t<decltype(box)>, kernel::Obb>; });
    if (is_oriented) block.oriented = static_cast<TreeBlock::Bits>(block.oriented | 1U << i);
  }
  return block;
}

/// Whether the block is of nodes of this tree, side by side, and all that are no leaves are divided in blocks after it, into
/// two nodes or more. So no descent meets a block twice.
bool is_of(const Hierarchy& hierarchy, std::span<const TreeBlock> blocks, std::size_t index) {
  const TreeBlock& block = blocks[index];
  const auto nodes = hierarchy.nodes();
  const std::size_t size = block.size();
  const auto taken = std::span(block.node).first(size);
  if (size == 0 || !are_ascending_below(taken, nodes.size())) return false;
  for (std::size_t i = 0; i + 1 < size; ++i) {
    if (nodes[taken[i]].first + nodes[taken[i]].count != nodes[taken[i + 1]].first) return false;
  }
  TreeBlock expected = block_of(hierarchy, taken);
  for (std::size_t i = 0; i < size; ++i) {
    if (nodes[taken[i]].is_leaf()) continue;
    const std::uint32_t below = block.below[i];
    if (below <= index || below >= blocks.size() || blocks[below].size() < 2) return false;
    const ItemRange items = blocks[below].items();
    if (items.first != block.begin[i] || items.count != block.count(i)) return false;
    expected.divide(i, below);
  }
  return std::memcmp(&expected, &block, sizeof block) == 0;  // NOLINT: doubles must have the same bits
}

}  // namespace

HierarchyBlocks::HierarchyBlocks(const Hierarchy& hierarchy, const Checkpoint& checkpoint) {
  const auto nodes = hierarchy.nodes();
  const BlockPartition partition(nodes);
  std::vector<TreeBlock> blocks;
  // Depth-first, as the descents read them. What is still to be made is below node i of a block.
  struct Pending {
    std::uint32_t node, block, i;
  };
  std::vector<Pending> pending{{0, TreeBlock::kNone, 0}};
  while (!pending.empty()) {
    checkpoint.at(blocks.size());
    const auto [node, above, at] = pending.back();
    pending.pop_back();
    const NodeFront front(nodes, partition, node);
    const auto index = static_cast<std::uint32_t>(blocks.size());
    if (above != TreeBlock::kNone) blocks[above].divide(at, index);
    blocks.push_back(block_of(hierarchy, front.found()));
    for (auto i = static_cast<std::uint32_t>(front.found().size()); i-- > 0;) {
      if (!nodes[front.found()[i]].is_leaf()) pending.push_back({front.found()[i], index, i});
    }
  }
  blocks.shrink_to_fit();
  blocks_ = std::move(blocks);
}

void HierarchyBlocks::append_parts(PartWriter& parts) const { parts.put(kPart, blocks_); }

HierarchyBlocks HierarchyBlocks::from_parts(const PartReader& parts, const Hierarchy& hierarchy,
                                            const Checkpoint& checkpoint) {
  HierarchyBlocks result;
  result.blocks_ = parts.get<TreeBlock>(kPart);
  const std::span blocks(result.blocks_);
  const auto is_block = [&](std::size_t i) { return is_of(hierarchy, blocks, i); };
  const auto is_all = [&] { return blocks[0].items().first == 0 && blocks[0].items().count == hierarchy.nodes()[0].count; };
  if (blocks.empty() || !are_all(blocks.size(), is_block, checkpoint) || !is_all()) {
    refuse_part(kPart, "the blocks are not of this tree");
  }
  return result;
}

}  // namespace occlude::culler
