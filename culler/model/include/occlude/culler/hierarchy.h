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
#include <string_view>
#include <vector>

#include "occlude/culler/box.h"
#include "occlude/culler/executor.h"
#include "occlude/culler/parts.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// The bounding volumes of the nodes. `obb`: an oriented box where its surface is below 0.8 of the axis-aligned one's.
enum class Bounds { aabb, obb };

/// A node holds items [first, first + count), in the order of the leaves, and `box` holds all of them. Nodes are in
/// depth-first order: the left child follows its parent, the right child is node `right`. A leaf has right = 0. Each is one
/// line of the cache.
struct alignas(64) HierarchyNode {
  kernel::Aabb box;
  std::uint32_t first = 0, count = 0, right = 0;
  std::uint32_t unused = 0;  ///< fills the line, so that every byte of a node has a value

  [[nodiscard]] bool is_leaf() const { return right == 0; }
};

/// The most levels of nodes, or of cells of space, below the root. What recurses takes some hundred bytes of stack for
/// each, up to a kilobyte under sanitizers, and so 256 KiB at most. Halving 2^32 items takes 32 levels, and the trees of the
/// models tried have 22 to 31: what has more is hostile.
inline constexpr std::uint32_t kMostLevels = 256;

struct BoxTree;
class PartReader;  // model/part_list.h
class PartWriter;

/// Const calls may run on several threads at once. Indices are not checked.
class Hierarchy {
 public:
  struct Config {
    /// The most polygons of a leaf; 0 counts as 1. Smaller leaves cull more, but cost more tests and make more, shorter draw
    /// ranges.
    std::uint32_t leaf_size = 4;
    Bounds bounds = Bounds::aabb;
  };

  using Node = HierarchyNode;

  /// Builds top-down, splitting where the surface area heuristic (Goldsmith and Salmon 1987) estimates the least cost.
  /// Takes the soup, whose vertices stay where they are. What `checkpoint` throws is thrown on.
  /// REQUIRES: soup is well formed and not empty, and its coordinates are in the kernel's legal range.
  [[nodiscard]] static Hierarchy build(PolygonSoup soup, const Config& config, const Checkpoint& checkpoint = {});

  /// The polygons in the order of the leaves. It has no `faces`.
  [[nodiscard]] const SoupView& soup() const { return soup_.view; }
  [[nodiscard]] const SharedSoup& shared_soup() const { return soup_; }
  /// Config::leaf_size. With the input it fixes the order of the polygons, whatever the bounding volumes are.
  [[nodiscard]] std::uint32_t leaf_size() const { return leaf_size_; }
  /// Index in the input of polygon p of soup().
  [[nodiscard]] std::uint32_t original(std::size_t p) const { return order_[p]; }
  /// The face of the input that polygon p of soup() is, or of which it is a piece.
  [[nodiscard]] std::uint32_t face(std::size_t p) const { return faces_.empty() ? order_[p] : faces_[order_[p]]; }
  [[nodiscard]] std::size_t face_count() const { return faces_.empty() ? order_.size() : faces_.back() + std::size_t{1}; }
  /// SoupView::faces of the input.
  [[nodiscard]] std::span<const std::uint32_t> faces() const { return faces_; }
  /// Number of fan triangles in polygons [0, p) of soup(); p may be soup().size().
  [[nodiscard]] std::size_t first_triangle(std::size_t p) const { return soup().first[p] - 2 * p; }
  /// The root first.
  [[nodiscard]] std::span<const Node> nodes() const { return nodes_; }
  /// The leaf (index in nodes()) that holds polygon p of soup().
  [[nodiscard]] std::uint32_t leaf_of(std::uint32_t p) const;
  /// Returns question(box), where `box` is the bounding volume of the node: a kernel::Aabb or a kernel::Obb that holds
  /// every polygon of the node exactly.
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
  friend class Culler;
  static constexpr std::uint32_t kNone = (std::numeric_limits<std::uint32_t>::max)();

  /// The parts of a tree, for Culler::parts().
  void append_parts(PartWriter& parts) const;
  /// Whether append_parts() appends a part of this name.
  [[nodiscard]] static bool is_part(std::string_view name);
  /// The tree with these parts, which must be one of build() in every respect but the shape of the tree and the oriented
  /// boxes: the soup is legal, each polygon is in one leaf, and each axis-aligned box is the smallest that holds its
  /// polygons. Throws std::invalid_argument otherwise. REQUIRES, not checked: an oriented box holds the polygons of its
  /// node.
  [[nodiscard]] static Hierarchy from_parts(const PartReader& parts, const Config& config,
                                            const Checkpoint& checkpoint = {});

  Hierarchy() = default;
  Hierarchy(PolygonSoup soup, const Config& config, BoxTree tree, const Checkpoint& checkpoint);

  void fit_oriented_boxes(const Checkpoint& checkpoint);

  Array<std::uint32_t> faces_;
  SharedSoup soup_;  ///< without faces
  std::uint32_t leaf_size_ = 0;
  Array<std::uint32_t> order_;
  Array<Node> nodes_;
  Array<kernel::Obb> oriented_boxes_;
  Array<std::uint32_t> oriented_;  ///< of each node, the index in oriented_boxes_ or kNone; empty with Bounds::aabb
};

/// Polygons [first, first + count) of a DrawOrder, all of this material.
struct MaterialRange {
  std::uint32_t material = 0, first = 0, count = 0;

  friend bool operator==(const MaterialRange&, const MaterialRange&) = default;
};

/// An order of polygons for index buffers: those of each material together, the lowest number first. A material is a number
/// of the caller's for what is drawn together: a texture, a shader, a layer. Within a material polygons are in the order of
/// the leaves. So what a frame draws of a material is few ranges, even where the materials of a leaf are many. Neither the
/// tree nor what is culled depends on materials, and a model may have several orders: one for colours, and one for depth
/// alone. Const calls may run on several threads at once.
class DrawOrder {
 public:
  /// `materials` has a number, any number, for each face of the input: for each polygon, unless faces have pieces
  /// (SoupView::faces). Throws std::invalid_argument if they are not as many.
  DrawOrder(const Hierarchy& hierarchy, std::span<const std::uint32_t> materials);

  /// The polygons in this order, by their numbers in the input.
  [[nodiscard]] std::span<const std::uint32_t> polygons() const { return polygons_; }
  /// Number of fan triangles in the first `i` of these polygons.
  [[nodiscard]] std::size_t first_triangle(std::size_t i) const { return first_triangle_[i]; }
  /// The range of each material that there is. With an index buffer for each material, subtract its `first` from those of
  /// its ranges.
  [[nodiscard]] std::span<const MaterialRange> materials() const { return materials_; }

  /// Replaces `ranges` with what to draw where the culler draws `drawn` (CullResult::drawn): the same polygons, in ascending
  /// order, neighbours of one material merged. REQUIRES: `drawn` has ranges of Hierarchy::soup() that do not overlap, and
  /// none is empty.
  void find_ranges(std::span<const PolygonRange> drawn, std::vector<MaterialRange>& ranges) const;

 private:
  /// Polygons of one material that follow one another in both orders.
  struct Run {
    std::uint32_t in_tree;  ///< the first one's place in Hierarchy::soup(); the run ends where the next begins
    std::uint32_t first;    ///< its place in this order
    std::uint32_t material;
  };

  std::vector<std::uint32_t> polygons_, first_triangle_;
  std::vector<MaterialRange> materials_;
  std::vector<Run> runs_;  ///< ascending in the tree
};

}  // namespace occlude::culler
