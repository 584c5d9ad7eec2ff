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

/// `boxes` are those of all items, by their number. Nothing is allocated for a tree no larger than one before it.
struct BoxTree {
  std::vector<std::uint32_t> order;  ///< items, in the order of the leaves
  std::vector<HierarchyNode> nodes;
  std::vector<std::uint32_t> spare = {};  ///< memory of append()

  /// Appends the nodes of a tree over order[first, first + count) and brings these items into the order of its leaves, each
  /// of at most `leaf_size`. Top-down, splitting where the surface area heuristic (Goldsmith and Salmon 1987) estimates the
  /// least cost. REQUIRES: count > 0, leaf_size > 0.
  void append(std::span<const kernel::Aabb> boxes, std::uint32_t first, std::uint32_t count, std::uint32_t leaf_size,
              const Checkpoint& checkpoint = {});

  /// Fits the nodes from this one on to their items once more, bottom-up; the shape of the tree stays.
  void refit(std::span<const kernel::Aabb> boxes, std::size_t from);
  /// Fits an inner node to its children.
  void join_children(std::size_t node);

  /// What the surface area heuristic adds up for a descent of the nodes from this one on: half the surfaces of the inner
  /// ones, in model units squared.
  [[nodiscard]] double cost(std::size_t from) const;
};

}  // namespace occlude::culler
