// SPDX-License-Identifier: MIT
// A binary tree over boxes that is built in linear time, for what changes from frame to frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "model/curve_order.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// The items are sorted along a curve and split where the highest bit of their places on it changes (Lauterbach et al.
/// 2009). Building a tree that is no larger than an earlier one allocates nothing.
class LinearTree {
 public:
  /// Builds a tree over the boxes; without boxes, one without nodes. REQUIRES: finite boxes, leaf_size > 0.
  void build(std::span<const kernel::Aabb> boxes, std::uint32_t leaf_size);

  /// Depth-first, the root first. Their boxes hold the boxes of their items exactly.
  [[nodiscard]] std::span<const HierarchyNode> nodes() const { return nodes_; }
  /// The indices of the boxes, in the order of the leaves.
  [[nodiscard]] std::span<const std::uint32_t> order() const { return curve_.order(); }
  /// The bytes of memory that it holds.
  [[nodiscard]] std::size_t bytes() const;

 private:
  void append(std::span<const kernel::Aabb> boxes, std::uint32_t first, std::uint32_t count, std::uint32_t leaf_size);
  [[nodiscard]] std::uint32_t left_of(std::uint32_t first, std::uint32_t count) const;

  std::vector<HierarchyNode> nodes_;
  CurveOrder curve_;
};

}  // namespace occlude::culler
