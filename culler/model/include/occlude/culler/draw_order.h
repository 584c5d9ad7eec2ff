// SPDX-License-Identifier: MIT
// The polygons of a model by their materials, so that what is drawn never crosses from one to another. Reading order: 9.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "occlude/culler/hierarchy.h"

namespace occlude::culler {

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
  /// The range of each material that there is. For an index buffer of its own, its ranges begin at its first polygon.
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
