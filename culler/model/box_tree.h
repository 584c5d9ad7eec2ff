// SPDX-License-Identifier: MIT
// A binary tree over the boxes of polygons.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "occlude/culler/executor.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

struct BoxTree {
  std::vector<std::uint32_t> order;  ///< items, in the order of the leaves
  std::vector<HierarchyNode> nodes;

  /// The tree of items with these boxes. Leaves have at most `leaf_size` items each. Splits top-down where the surface area
  /// heuristic (Goldsmith and Salmon 1987) estimates the least cost, and in halves where there would be more than
  /// kMostLevels levels otherwise. REQUIRES: there is a box, leaf_size > 0.
  [[nodiscard]] static BoxTree build(std::span<const kernel::Aabb> boxes, std::uint32_t leaf_size,
                                     const Checkpoint& checkpoint = {});
};

}  // namespace occlude::culler
