// SPDX-License-Identifier: MIT
// The cells of a partition, of either kind.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "frusta/partition.h"
#include "occlude/culler/executor.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

struct PartitionCells {
  kernel::Aabb box;  ///< of the first one
  std::vector<Partition::Cell> cells = {};

  /// Appends the cells of `part`: a region, or where divide(part) says how it is divided, a plane and both sides of it.
  template <class Part, class Divide>
  void append(const Part& part, const Divide& divide) {
    const std::size_t self = cells.size();
    cells.emplace_back();
    const auto divided = divide(part);
    if (!divided) return;
    append(divided->lower, divide);
    cells[self] = {divided->plane, divided->axis, static_cast<std::uint32_t>(cells.size())};
    append(divided->upper, divide);
  }
};

/// How append() is to divide a part.
template <class Part>
struct Divided {
  double plane;
  std::uint32_t axis;
  Part lower, upper;
};

/// How many cubes cells_of_grid() makes.
[[nodiscard]] double regions_of_grid(const kernel::Aabb& space, double regions);
[[nodiscard]] PartitionCells cells_of_grid(const kernel::Aabb& space, double regions);
[[nodiscard]] PartitionCells cells_of_tree(const Space& space, double regions, const Checkpoint& checkpoint);

}  // namespace occlude::culler
