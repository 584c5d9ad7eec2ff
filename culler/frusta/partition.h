// SPDX-License-Identifier: MIT
// The spatial partition of section 3.1: every point of space maps to one of finitely many regions, which are boxes. It
// serves the choice of occluders alone. Reading order: 7.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

#include "occlude/culler/cull_result.h"
#include "occlude/culler/executor.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/culler/parts.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// Where viewpoints are, about, and what stands there.
struct Space {
  kernel::Aabb box;
  /// A hierarchy of what stands in it. Without nodes it is taken for empty.
  std::span<const HierarchyNode> nodes = {};

  [[nodiscard]] static Space of(const Hierarchy& model) { return {model.nodes()[0].box, model.nodes()}; }
};

/// Regions are the leaves of a binary tree of cells. The first cell is a box that holds the space. A cell that is no region
/// is divided in two by a plane across an axis.
/// 1. Each point is in exactly one region: a point on a plane is in the upper cell. A point outside the box is in the region
///    of the point of the box that is nearest to it, which is the nearest region.
/// 2. The boxes of the regions, which are closed, fill the box. They have no more than faces in common.
/// 3. The same space, kind and number always give the same regions.
/// Const calls may run on several threads at once. Numbers of regions and cells are not checked.
class Partition {
 public:
  /// A region, or a plane and the cells on both sides. The lower one is the next cell. The cells are in depth-first order.
  struct Cell {
    double plane = 0;
    std::uint32_t axis = 0;
    std::uint32_t upper = 0;  ///< the cell on the upper side; 0 for a region

    [[nodiscard]] bool is_region() const { return upper == 0; }
  };

  /// Beyond this number of regions, counting them would take all memory.
  static constexpr double kMostRegions = 0x1p30;
  [[nodiscard]] static bool can_have(double regions) { return regions >= 1 && regions <= kMostRegions; }

  /// About as many regions as wanted; of a tree no more. Takes no part of `space` with it. Throws std::invalid_argument
  /// unless it can_have() so many, and what `checkpoint` throws. REQUIRES: kernel::check(space.box) == Refusal::none, and
  /// space.box holds the nodes.
  [[nodiscard]] static Partition make(RegionKind kind, const Space& space, double regions,
                                      const Checkpoint& checkpoint = {});

  /// How many regions make() makes: of a grid so many, of a tree no more. Takes no time.
  [[nodiscard]] static double most_regions(RegionKind kind, const Space& space, double regions);

  /// For Culler::parts().
  void append_parts(PartWriter& parts) const;
  /// The regions with these parts. Throws std::invalid_argument unless the cells are a tree with finite planes.
  [[nodiscard]] static Partition from_parts(const PartReader& parts);

  /// Number of regions. They are numbered in the order of their cells.
  [[nodiscard]] std::size_t regions() const { return (cells_.size() + 1) / 2; }
  /// The region that a point is in. REQUIRES: the point is finite.
  [[nodiscard]] std::size_t region_at(const glm::dvec3& point) const;
  [[nodiscard]] kernel::Aabb box(std::size_t region) const;

  [[nodiscard]] std::span<const Cell> cells() const { return cells_; }
  [[nodiscard]] kernel::Aabb cell_box(std::size_t cell) const;

 private:
  Partition(const kernel::Aabb& box, std::vector<Cell> cells) : box_(box), cells_(std::move(cells)) {}

  /// How many of the cells from `first` to before `end`, which are all of a subtree: half of them and one half.
  [[nodiscard]] std::size_t regions_between(std::size_t first, std::size_t end) const { return (end - first + 1) / 2; }

  kernel::Aabb box_;
  Array<Cell> cells_;
};

}  // namespace occlude::culler
