// SPDX-License-Identifier: MIT
#include "model/packed_tree.h"

namespace occlude::culler {

void PackedTree::build(std::span<const kernel::Aabb> boxes, std::span<const std::uint32_t> order) {
  clear();
  const auto blocks_of = [](std::uint32_t n) { return n / kWidth + (n % kWidth != 0 ? 1 : 0); };
  std::uint32_t end = 0;
  for (auto n = static_cast<std::uint32_t>(boxes.size()); n > 0; n = n > kWidth ? blocks_of(n) : 0) {
    begin_[levels_] = end;
    boxes_[levels_++] = n;
    end += blocks_of(n);
  }
  blocks_.resize(end);
  for (std::uint32_t i = 0; i < boxes.size(); ++i) blocks_[i / kWidth].set(i % kWidth, boxes[order[i]]);
  for (std::uint32_t level = 0; level < levels_; ++level) {
    for (std::uint32_t b = 0; b < blocks_of(boxes_[level]); ++b) {
      const kernel::BoxBlock& block = this->block({level, b});
      kernel::Aabb all = empty_box();
      for (std::uint32_t i = 0; i < std::min(kWidth, boxes_[level] - kWidth * b); ++i) grow(all, block.box(i));
      if (level + 1 == levels_) {
        box_ = all;
      } else {
        blocks_[begin_[level + 1] + b / kWidth].set(b % kWidth, all);
      }
    }
  }
}

void PackedTree::clear() {
  blocks_.clear();
  levels_ = 0;
  box_ = empty_box();
}

}  // namespace occlude::culler
