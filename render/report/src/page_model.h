// SPDX-License-Identifier: MIT
// A model as the page of a walk holds it: leaves of polygons whose corners are rounded to a grid.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "occlude/culler/hierarchy.h"

namespace occlude::render {

/// A point of a PageGrid: steps along each axis.
using GridPoint = std::array<std::uint32_t, 3>;

/// A grid over the box of a model, of less than 2^24 steps on each axis: as fine as single precision. The step is a power of
/// two. If all coordinates are multiples of a coarser one, the step is the coarsest such, and nothing is rounded.
struct PageGrid {
  static constexpr unsigned kBits = 24;

  glm::dvec3 low{0, 0, 0};
  double step = 1;
  GridPoint steps{};  ///< to the far corner of the box

  explicit PageGrid(std::span<const glm::dvec3> points);
  /// The nearest point of the grid.
  [[nodiscard]] GridPoint at(const glm::dvec3& point) const;
};

/// The polygons of a page are in the order of the leaves, and within a leaf in the order of their numbers in the model file.
/// The leaves are those of the tree; fates are told of whole leaves.
class PageModel {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  /// Of larger models the page leaves out the smallest polygons.
  static constexpr std::size_t kMostPolygons = 2'000'000;

  explicit PageModel(const culler::Hierarchy& hierarchy, std::size_t most = kMostPolygons);

  [[nodiscard]] const PageGrid& grid() const { return grid_; }
  [[nodiscard]] std::size_t polygons() const { return polygons_; }
  [[nodiscard]] std::size_t leaves() const { return leaf_first_.size(); }
  /// The place in the page of polygon p of the tree; kNone if the page leaves it out.
  [[nodiscard]] std::uint32_t place(std::uint32_t p) const { return place_[p]; }
  /// The leaves that have these polygons of the tree, and no others: the first leaf, and their number.
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> leaves_of(const culler::PolygonRange& polygons) const;
  /// The leaf of polygon p of the tree.
  [[nodiscard]] std::uint32_t leaf_of(std::uint32_t p) const;

  // What page/unpack.js reads.

  [[nodiscard]] const std::string& vertices() const { return vertices_; }  ///< see pack_vertices() in page_model.cpp
  /// For each leaf its number of polygons.
  [[nodiscard]] const std::string& leaf_sizes() const { return leaf_sizes_; }
  /// For each polygon twice its number of corners, and 1 more if it is see-through.
  [[nodiscard]] const std::string& sides() const { return sides_; }
  /// For each corner how far its vertex is before the first one not yet used.
  [[nodiscard]] const std::string& corners() const { return corners_; }
  /// For each polygon the difference of its number in the model file from that of the one before.
  [[nodiscard]] const std::string& numbers() const { return numbers_; }

 private:
  PageGrid grid_;
  std::size_t polygons_ = 0;
  std::vector<std::uint32_t> leaf_first_;  ///< of each leaf, its first polygon in the tree
  std::vector<std::uint32_t> place_;
  std::string vertices_, leaf_sizes_, sides_, corners_, numbers_;
};

}  // namespace occlude::render
