// SPDX-License-Identifier: MIT
// The cells of a grid: cubes of one size.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "frusta/partition_cells.h"
#include "model/bounds.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {
namespace {

using Index = std::array<std::uint32_t, 3>;

/// Cubes of one edge in a box.
struct Grid {
  glm::dvec3 origin;
  double edge;
  Index size;  ///< cubes along each axis

  /// About so many.
  Grid(const kernel::Aabb& space, double regions) : origin(to_glm(space.min)), size{} {
    const glm::dvec3 extent = to_glm(space.max) - origin;
    // A flat box counts as at least 1/1000 thick so that the edge stays in proportion to the model.
    const double largest = std::max({extent.x, extent.y, extent.z, kernel::kMinMagnitude});
    const glm::dvec3 solid = glm::max(extent, largest / 1000);
    edge = largest * std::cbrt(solid.x / largest * (solid.y / largest) * (solid.z / largest) / regions);
    for (int axis = 0; axis < 3; ++axis) {
      size[static_cast<std::size_t>(axis)] = static_cast<std::uint32_t>(extent[axis] / edge) + 1;
    }
  }

  [[nodiscard]] double place(int axis, std::uint32_t index) const { return origin[axis] + edge * index; }
};

/// Cubes from `low` to before `high`.
struct Block {
  Index low, high;
};

}  // namespace

double regions_of_grid(const kernel::Aabb& space, double regions) {
  const Index size = Grid(space, regions).size;
  return static_cast<double>(size[0]) * size[1] * size[2];
}

PartitionCells cells_of_grid(const kernel::Aabb& space, double regions) {
  const Grid grid(space, regions);
  const Block all{{}, grid.size};
  kernel::Aabb box = space;
  for (int axis = 0; axis < 3; ++axis) {
    box.max[axis] = std::max(space.max[axis], grid.place(axis, grid.size[static_cast<std::size_t>(axis)]));
  }
  PartitionCells result{box};
  result.append(all, [&](const Block& block) -> std::optional<Divided<Block>> {
    const Index size{block.high[0] - block.low[0], block.high[1] - block.low[1], block.high[2] - block.low[2]};
    const auto axis = static_cast<std::uint32_t>(std::ranges::max_element(size) - size.begin());
    if (size[axis] == 1) return std::nullopt;
    const std::uint32_t middle = block.low[axis] + size[axis] / 2;
    Divided<Block> halves{grid.place(static_cast<int>(axis), middle), axis, block, block};
    halves.lower.high[axis] = halves.upper.low[axis] = middle;
    return halves;
  });
  return result;
}

}  // namespace occlude::culler
