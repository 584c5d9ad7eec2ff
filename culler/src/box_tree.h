// SPDX-License-Identifier: MIT
// A binary tree over the boxes of some items: polygons of a model, objects of a scene.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "occlude/culler/checkpoint.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// `boxes` has the boxes of all items, by their number. Building a tree that is no larger than an earlier one allocates
/// nothing.
struct BoxTree {
  std::vector<std::uint32_t> order;  ///< items, in the order of the leaves
  std::vector<HierarchyNode> nodes;
  std::vector<std::uint32_t> spare = {};  ///< memory of append()

  /// Appends the nodes of a tree over order[first, first + count) and puts these items into the order of its leaves, which
  /// have at most `leaf_size` items each. Splits top-down where the surface area heuristic (Goldsmith and Salmon 1987)
  /// estimates the least cost. REQUIRES: count > 0, leaf_size > 0.
  void append(std::span<const kernel::Aabb> boxes, std::uint32_t first, std::uint32_t count, std::uint32_t leaf_size,
              const Checkpoint& checkpoint = {});

  /// Refits the boxes of the nodes with index >= `from` to their items, bottom-up. The shape of the tree stays.
  void refit(std::span<const kernel::Aabb> boxes, std::size_t from);
  /// Fits an inner node to its children.
  void join_children(std::size_t node);

  /// The cost of a descent of the nodes with index >= `from` by the surface area heuristic: the sum of half the surfaces of
  /// the inner nodes, in model units squared.
  [[nodiscard]] double cost(std::size_t from) const;
};

}  // namespace occlude::culler
