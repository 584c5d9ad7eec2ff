// SPDX-License-Identifier: MIT
#include "model/linear_tree.h"

#include <algorithm>
#include <bit>

#include "model/bounds.h"

namespace occlude::culler {

void LinearTree::build(std::span<const kernel::Aabb> boxes, std::uint32_t leaf_size) {
  nodes_.clear();
  curve_.sort(boxes);
  if (boxes.empty()) return;
  append(boxes, 0, static_cast<std::uint32_t>(boxes.size()), leaf_size);
}

/// Appends the subtree over order()[first, first + count).
void LinearTree::append(std::span<const kernel::Aabb> boxes, std::uint32_t first, std::uint32_t count,
                        std::uint32_t leaf_size) {
  const std::size_t self = nodes_.size();
  nodes_.push_back({.box = empty_box(), .first = first, .count = count});
  if (count <= leaf_size) {
    for (std::uint32_t i = first; i < first + count; ++i) grow(nodes_[self].box, boxes[order()[i]]);
    return;
  }
  const std::uint32_t left = left_of(first, count);
  append(boxes, first, left, leaf_size);
  const std::size_t right = nodes_.size();
  append(boxes, first + left, count - left, leaf_size);
  nodes_[self].right = static_cast<std::uint32_t>(right);
  nodes_[self].box = nodes_[self + 1].box;
  grow(nodes_[self].box, nodes_[right].box);
}

/// How many items go left: those before the change of the highest bit in which their codes differ, or half of them where all
/// codes are the same. So a tree has no more levels than a code has bits, and the logarithm of the number of items more.
std::uint32_t LinearTree::left_of(std::uint32_t first, std::uint32_t count) const {
  const auto begin = curve_.codes().begin() + first, end = begin + count;
  const std::uint32_t differ = *begin ^ *(end - 1);
  if (differ == 0) return count / 2;
  const std::uint32_t bit = std::bit_floor(differ);
  return static_cast<std::uint32_t>(std::partition_point(begin, end, [&](std::uint32_t c) { return (c & bit) == 0; }) -
                                    begin);
}

std::size_t LinearTree::bytes() const { return nodes_.capacity() * sizeof(HierarchyNode) + curve_.bytes(); }

}  // namespace occlude::culler
