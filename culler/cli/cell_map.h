// SPDX-License-Identifier: MIT
// A picture of cells from above, coloured by a number of each.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "occlude/kernel/types.h"
#include "occlude/render/image.h"

namespace occlude::cli {

/// The axis of the coordinates that is up.
struct UpAxis {
  int axis = 2;
  bool is_down = false;  ///< up is against it
};

/// None if `up` is not along an axis.
[[nodiscard]] std::optional<UpAxis> axis_of(const glm::dvec3& up);

struct MapCell {
  kernel::Aabb box;
  std::size_t number;
};

/// The picture from above, at most 1024 pixels wide and high. A pixel has the greatest number of the cells that hold its
/// middle: from dark blue for 0 over red to yellow for the greatest of all. Where there are none it is transparent. Each
/// cell has a pixel at least. REQUIRES: there are cells.
[[nodiscard]] render::Image map_of(std::span<const MapCell> cells, const UpAxis& up);

}  // namespace occlude::cli
