// SPDX-License-Identifier: MIT
// Cells of eyes: boxes for which `occlude bake` makes visible sets.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "occlude/culler/polygon_soup.h"
#include "occlude/kernel/types.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/walk.h"
#include "path_arguments.h"

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

  /// The fewest that cover the box: what only touches it is not among them. Where a flat box lies between two, that is the
  /// higher one. Throws std::length_error for more than kMostCells.
  [[nodiscard]] std::vector<kernel::Aabb> cells_of(const kernel::Aabb& box) const;
  /// Some that cover all that is within `reach`, on each axis, of the straight ways from each eye of the path to the next.
  /// None is farther from them than that and half a size. With a layer this holds on the two other axes. Throws as
  /// cells_of().
  [[nodiscard]] std::vector<kernel::Aabb> cells_along(const render::CameraPath& path, double reach) const;
};

/// The path that cells lie along. Warns as warn_of_misfit(). Throws as `arguments.through(model)`, and InputError for one
/// with parallel rays: its eyes are infinitely far, and what they see is not what is seen from the way. `soup` is the
/// model's.
[[nodiscard]] render::CameraPath way_of_eyes(const PathArguments& arguments, const render::ModelFile& model,
                                             culler::SoupView soup);

/// Reads a list: {"cells":[{"min":[x,y,z],"max":[x,y,z]}, …]}. Throws InputError, naming the file and the cell.
[[nodiscard]] std::vector<kernel::Aabb> read_cells(const std::string& file);

/// The cell in equal pieces that share their faces. They are no longer than `side` along any axis, or by a millionth of it.
/// Throws std::length_error, naming the cell and the side, for more than kMostCells.
[[nodiscard]] std::vector<kernel::Aabb> pieces_of(const kernel::Aabb& cell, double side);

}  // namespace occlude::cli
