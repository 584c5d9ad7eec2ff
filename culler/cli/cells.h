// SPDX-License-Identifier: MIT
// Cells of eyes: boxes for which `occlude bake` makes visible sets.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "occlude/kernel/types.h"
#include "occlude/render/camera_path.h"

namespace occlude::cli {

/// As many as there may be: a set of cells is made for each, and of all pairs.
inline constexpr std::size_t kMostCells = std::size_t{1} << 16U;

/// Cubes whose faces lie at whole multiples of a size. Neighbours have the same numbers on the faces that they share. One
/// layer of a given height may take the place of all cubes above each other.
struct CellGrid {
  struct Layer {
    double low, high;  ///< along `up`
    int axis;
    bool is_down;  ///< up is against the axis
  };

  double size = 2;
  std::optional<Layer> layer;

  /// Those that hold points of the box. Throws std::length_error for more than kMostCells.
  [[nodiscard]] std::vector<kernel::Aabb> cells_of(const kernel::Aabb& box) const;
  /// Those within `reach` of the way of the path's eyes, on each axis; with a layer, on the two others.
  [[nodiscard]] std::vector<kernel::Aabb> cells_along(const render::CameraPath& path, double reach) const;
};

/// Reads a list: {"cells":[{"min":[x,y,z],"max":[x,y,z]}, …]}. Throws InputError, naming the file and the cell.
[[nodiscard]] std::vector<kernel::Aabb> read_cells(const std::string& file);

/// The cell in equal pieces, no longer than `side` along any axis, that share their faces. Throws std::length_error for more
/// than kMostCells.
[[nodiscard]] std::vector<kernel::Aabb> pieces_of(const kernel::Aabb& cell, double side);

}  // namespace occlude::cli
