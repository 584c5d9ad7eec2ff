// SPDX-License-Identifier: MIT
// The spatial hierarchy of section 3.1: a binary tree of AABBs or OBBs in which every polygon lies in exactly one leaf,
// unsplit.
// Reading order: 3.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "occlude/culler/box.h"
#include "occlude/culler/checkpoint.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// The bounding volumes of the nodes. `obb`: oriented boxes where they are smaller than axis-aligned ones.
enum class Bounds { aabb, obb };

/// Holds items [first, first + count) of the order of the leaves, all of them within `box`. Nodes lie in depth-first order:
/// the left child follows its parent, the right child has the index `right`; a leaf has right = 0.
struct HierarchyNode {
  kernel::Aabb box;
  std::uint32_t first = 0, count = 0, right = 0;

  [[nodiscard]] bool is_leaf() const { return right == 0; }
};

struct BoxTree;

class Hierarchy {
 public:
  struct Config {
    /// Most polygons in a leaf. Smaller leaves cull more and cost more tests and more, shorter draw ranges.
    std::uint32_t leaf_size = 16;
    Bounds bounds = Bounds::aabb;
  };

  using Node = HierarchyNode;

  /// What takes time to find: the order of the polygons and the shape of the tree. The boxes follow from them.
  struct Layout {
    std::vector<std::uint32_t> order;  ///< of the input's polygons, in the order of the leaves
    std::vector<std::uint32_t> left;   ///< of each node, depth-first, how many polygons its left child has; a leaf has 0
  };

  /// Builds top-down, splitting where the surface area heuristic (Goldsmith and Salmon 1987) estimates the least cost.
  /// REQUIRES: soup is not empty and its coordinates are in the kernel's legal range.
  [[nodiscard]] static Hierarchy build(const PolygonSoup& soup, const Config& config, const Checkpoint& checkpoint = {});

  /// The same tree from its layout. Throws std::invalid_argument when it cannot be a layout of this soup.
  [[nodiscard]] static Hierarchy restore(const PolygonSoup& soup, const Config& config, const Layout& layout,
                                         const Checkpoint& checkpoint = {});
  [[nodiscard]] Layout layout() const;

  /// The polygons in the order of the leaves.
  [[nodiscard]] const PolygonSoup& soup() const { return *soup_; }
  [[nodiscard]] const std::shared_ptr<const PolygonSoup>& shared_soup() const { return soup_; }
  /// Index in the input of polygon p of soup().
  [[nodiscard]] std::uint32_t original(std::size_t p) const { return order_[p]; }
  /// Number of fan triangles in polygons [0, p) of soup(); p may be soup().size().
  [[nodiscard]] std::size_t first_triangle(std::size_t p) const { return soup_->first[p] - 2 * p; }
  /// The root first.
  [[nodiscard]] std::span<const Node> nodes() const { return nodes_; }
  /// The leaf that has polygon p of soup().
  [[nodiscard]] std::uint32_t leaf_of(std::uint32_t p) const;
  /// Calls question(box) with the bounding volume of the node, an AABB or an OBB: it holds all polygons of the node,
  /// exactly.
  template <class Question>
  decltype(auto) ask(std::uint32_t node, Question&& question) const {
    const std::uint32_t i = oriented_.empty() ? kNone : oriented_[node];
    return i == kNone ? question(nodes_[node].box) : question(oriented_boxes_[i]);
  }
  [[nodiscard]] Box volume(std::uint32_t node) const {
    return ask(node, [](const auto& box) -> Box { return box; });
  }
  /// Number of nodes whose volume is an OBB.
  [[nodiscard]] std::size_t oriented() const { return oriented_boxes_.size(); }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  Hierarchy(const PolygonSoup& soup, const Config& config, BoxTree tree, const Checkpoint& checkpoint);

  void fit_oriented_boxes(const Checkpoint& checkpoint);

  std::shared_ptr<const PolygonSoup> soup_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
  std::vector<kernel::Obb> oriented_boxes_;
  std::vector<std::uint32_t> oriented_;  ///< of each node, the index in oriented_boxes_ or kNone; empty with Bounds::aabb
};

}  // namespace occlude::culler
