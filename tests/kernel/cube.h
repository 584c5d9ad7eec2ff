// SPDX-License-Identifier: MIT
// A cube as an occluder, written in two equivalent ways.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "occlude/kernel/types.h"

namespace occlude {

/// The ways to write a cube of side 2 whose minimum is `min`.
enum class CubeForm { quadrilaterals, triangles };

inline kernel::Polytope cube(const kernel::Vec3& min, CubeForm form = CubeForm::quadrilaterals) {
  kernel::Polytope result;
  for (const auto& [y, z] : {std::pair{0, 0}, {2, 0}, {2, 2}, {0, 2}}) {
    for (const int x : {0, 2}) result.vertices.push_back({min.x + x, min.y + y, min.z + z});
  }
  // Even vertices are at the lower x.
  result.faces = {{0, 2, 4, 6}, {1, 3, 5, 7}, {0, 2, 3, 1}, {2, 4, 5, 3}, {4, 6, 7, 5}, {6, 0, 1, 7}};
  if (form == CubeForm::triangles) {
    std::vector<std::vector<std::uint32_t>> triangles;
    for (const auto& f : result.faces) {
      triangles.push_back({f[0], f[1], f[2]});
      triangles.push_back({f[0], f[2], f[3]});
    }
    result.faces = std::move(triangles);
  }
  return result;
}

}  // namespace occlude
