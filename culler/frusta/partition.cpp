// SPDX-License-Identifier: MIT
#include "frusta/partition.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "frusta/partition_cells.h"
#include "model/part_list.h"

namespace occlude::culler {
namespace {

constexpr std::string_view kSpaceBox = "space", kSpaceCells = "cells";

/// Whether they are cells in depth-first order, each a region or divided by a plane. Throws std::invalid_argument if they
/// are deeper than kMostLevels.
bool are_tree(std::span<const Partition::Cell> cells) {
  struct Pending {
    std::size_t cell;
    std::uint32_t depth;
  };
  std::vector<Pending> upper;  // cells that are still to come
  std::uint32_t depth = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto& [plane, axis, next] = cells[i];
    if (axis > 2 || !std::isfinite(plane)) return false;
    if (!cells[i].is_region()) {
      if (depth == kMostLevels) refuse_depth(kSpaceCells);
      upper.push_back({next, ++depth});
    } else if (i + 1 < cells.size()) {
      if (upper.empty() || upper.back().cell != i + 1) return false;
      depth = upper.back().depth;
      upper.pop_back();
    }
  }
  return !cells.empty() && upper.empty() && cells.back().is_region();
}

}  // namespace

Partition Partition::make(RegionKind kind, const Space& space, double regions, const Checkpoint& checkpoint) {
  if (!can_have(regions)) throw std::invalid_argument("a partition cannot have so many regions");
  PartitionCells made =
      kind == RegionKind::grid ? cells_of_grid(space.box, regions) : cells_of_tree(space, regions, checkpoint);
  return {made.box, std::move(made.cells)};
}

double Partition::most_regions(RegionKind kind, const Space& space, double regions) {
  if (kind == RegionKind::grid) return regions_of_grid(space.box, regions);
  return std::min(regions, static_cast<double>(std::max<std::size_t>(space.nodes.size(), 1)));
}

void Partition::append_parts(PartWriter& parts) const {
  parts.put(kSpaceBox, std::span(&box_, 1));
  parts.put(kSpaceCells, cells_);
}

Partition Partition::from_parts(const PartReader& parts) {
  const auto box = parts.get<kernel::Aabb>(kSpaceBox);
  const auto is_finite = [](const kernel::Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
  };
  if (box.size() != 1 || !is_finite(box[0].min) || !is_finite(box[0].max)) refuse_part(kSpaceBox, "it is not a box");
  Partition result(box[0], {});
  result.cells_ = parts.get<Cell>(kSpaceCells);
  if (!are_tree(result.cells())) refuse_part(kSpaceCells, "it is not a tree of cells");
  return result;
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
