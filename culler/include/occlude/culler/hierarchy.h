// SPDX-License-Identifier: MIT
// The spatial hierarchy of section 3.1: a binary tree of AABBs in which every polygon lies in exactly one leaf, unsplit.
// Reading order: 3.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "occlude/culler/polygon_soup.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

class Hierarchy {
 public:
  struct Config {
    /// Most polygons in a leaf. Smaller leaves cull more and cost more tests and more, shorter draw ranges.
    std::uint32_t leaf_size = 16;
  };

  /// Holds polygons [first, first + count) of soup(), all of them within `box`. Nodes lie in depth-first order: the left
  /// child follows its parent, the right child has the index `right`; a leaf has right = 0.
  struct Node {
    kernel::Aabb box;
    std::uint32_t first = 0, count = 0, right = 0;

    [[nodiscard]] bool is_leaf() const { return right == 0; }
  };

  /// Builds top-down, splitting where the surface area heuristic (Goldsmith and Salmon 1987) estimates the least cost.
  /// REQUIRES: soup is not empty and its coordinates are in the kernel's legal range.
  [[nodiscard]] static Hierarchy build(const PolygonSoup& soup, const Config& config);

  /// The polygons in the order of the leaves.
  [[nodiscard]] const PolygonSoup& soup() const { return soup_; }
  /// Index in the input of polygon p of soup().
  [[nodiscard]] std::uint32_t original(std::size_t p) const { return order_[p]; }
  /// Number of fan triangles in polygons [0, p) of soup(); p may be soup().size().
  [[nodiscard]] std::size_t first_triangle(std::size_t p) const { return soup_.first[p] - 2 * p; }
  /// The root first.
  [[nodiscard]] std::span<const Node> nodes() const { return nodes_; }
  [[nodiscard]] const kernel::Aabb& box(std::size_t polygon) const { return boxes_[polygon]; }

 private:
  PolygonSoup soup_;
  std::vector<std::uint32_t> order_;
  std::vector<kernel::Aabb> boxes_;
  std::vector<Node> nodes_;
};

}  // namespace occlude::culler
