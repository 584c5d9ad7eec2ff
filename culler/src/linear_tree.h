// SPDX-License-Identifier: MIT
// A binary tree over boxes that is built in linear time, for what changes from frame to frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "occlude/culler/hierarchy.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// The items are sorted along a curve through space by the bits of their centres (Morton 1966), and split where the highest
/// bit changes (Lauterbach et al. 2009). Building a tree that is no larger than an earlier one allocates nothing.
class LinearTree {
 public:
  /// Builds a tree over the boxes; without boxes, one without nodes. REQUIRES: finite boxes, leaf_size > 0.
  void build(std::span<const kernel::Aabb> boxes, std::uint32_t leaf_size);

  /// Depth-first, the root first. Their boxes hold the boxes of their items exactly.
  [[nodiscard]] std::span<const HierarchyNode> nodes() const { return nodes_; }
  /// The indices of the boxes, in the order of the leaves.
  [[nodiscard]] std::span<const std::uint32_t> order() const { return order_; }
  /// The bytes of memory that it holds.
  [[nodiscard]] std::size_t bytes() const;

 private:
  void find_codes(std::span<const kernel::Aabb> boxes);
  void sort();
  void append(std::span<const kernel::Aabb> boxes, std::uint32_t first, std::uint32_t count, std::uint32_t leaf_size);
  [[nodiscard]] std::uint32_t left_of(std::uint32_t first, std::uint32_t count) const;

  std::vector<HierarchyNode> nodes_;
  std::vector<std::uint32_t> order_, codes_;
  std::vector<std::uint32_t> spare_order_, spare_codes_;  ///< memory of sort()
};

}  // namespace occlude::culler
