// SPDX-License-Identifier: MIT
#include "model/packed_tree.h"

namespace occlude::culler {
namespace {

std::size_t blocks_of(std::size_t boxes) { return (boxes + TreeBlock::kNodes - 1) / TreeBlock::kNodes; }

kernel::Aabb box_around(const TreeBlock& block) {
  kernel::Aabb all = empty_box();
  for (std::size_t i = 0; i < block.size(); ++i) grow(all, block.boxes.box(i));
  return all;
}

}  // namespace

void PackedTree::build(std::span<const kernel::Aabb> boxes, std::span<const std::uint32_t> order) {
  clear();
  if (boxes.empty()) return;
  size_ = static_cast<std::uint32_t>(boxes.size());
  std::size_t all = 0, count = blocks_of(size_);
  for (std::size_t level = count; level > 1; level = blocks_of(level)) all += blocks_of(level);
  first_of_items_ = all;
  blocks_.resize(all + count);
  for (std::uint32_t i = 0; i < size_; ++i) blocks_[all + i / TreeBlock::kNodes].add(boxes[order[i]], {i, 1});
  for (std::size_t first = all; count > 1; count = blocks_of(count)) {
    build_level_above(first - blocks_of(count), first, count);
    first -= blocks_of(count);
  }
  box_ = box_around(blocks_[0]);
}

/// Builds the level that begins with a block, above the `count` blocks that begin with `below`.
void PackedTree::build_level_above(std::size_t level, std::size_t below, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    TreeBlock& block = blocks_[level + i / TreeBlock::kNodes];
    const TreeBlock& under = blocks_[below + i];
    block.add(box_around(under), under.items());
    block.divide(i % TreeBlock::kNodes, static_cast<std::uint32_t>(below + i));
  }
}

void PackedTree::clear() {
  blocks_.clear();
  first_of_items_ = 0;
  size_ = 0;
  box_ = empty_box();
}

}  // namespace occlude::culler
