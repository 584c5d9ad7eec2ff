// SPDX-License-Identifier: MIT
#include "occlude/culler/partition.h"

#include <stdexcept>
#include <utility>

#include "partition_cells.h"

namespace occlude::culler {
namespace {

/// Beyond this counting them would take all memory.
constexpr double kMostRegions = 0x1p30;

}  // namespace

Partition Partition::make(Kind kind, const Space& space, double regions, const Checkpoint& checkpoint) {
  if (!(regions >= 1 && regions <= kMostRegions)) {
    throw std::invalid_argument("the number of regions must be from 1 to 2^30");
  }
  PartitionCells made = kind == Kind::grid ? cells_of_grid(space.box, regions) : cells_of_tree(space, regions, checkpoint);
  return {made.box, std::move(made.cells)};
}

std::size_t Partition::region_at(const glm::dvec3& point) const {
  std::size_t cell = 0, region = 0;
  while (!cells_[cell].is_region()) {
    const Cell& at = cells_[cell];
    if (point[static_cast<int>(at.axis)] < at.plane) {
      ++cell;
    } else {
      region += regions_between(cell + 1, at.upper);
      cell = at.upper;
    }
  }
  return region;
}

kernel::Aabb Partition::box(std::size_t region) const {
  std::size_t cell = 0;
  while (!cells_[cell].is_region()) {
    const std::size_t lower = regions_between(cell + 1, cells_[cell].upper);
    if (region < lower) {
      ++cell;
    } else {
      region -= lower;
      cell = cells_[cell].upper;
    }
  }
  return cell_box(cell);
}

kernel::Aabb Partition::cell_box(std::size_t cell) const {
  kernel::Aabb box = box_;
  for (std::size_t above = 0; above != cell;) {
    const auto [plane, axis, upper] = cells_[above];
    const auto a = static_cast<int>(axis);
    if (cell < upper) {
      box.max[a] = plane;
      ++above;
    } else {
      box.min[a] = plane;
      above = upper;
    }
  }
  return box;
}

}  // namespace occlude::culler
