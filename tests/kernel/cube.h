// SPDX-License-Identifier: MIT
// A cube as an occluder, in several spellings that mean the same.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "occlude/kernel/types.h"

namespace occlude {

/// The ways to write one cube from `min`, of side 2.
enum class CubeForm { quadrilaterals, triangles, with_t_junction };

inline kernel::Polytope cube(const kernel::Vec3& min, CubeForm form = CubeForm::quadrilaterals) {
  kernel::Polytope result;
  for (const auto& [y, z] : {std::pair{0, 0}, {2, 0}, {2, 2}, {0, 2}}) {
    for (const int x : {0, 2}) result.vertices.push_back({min.x + x, min.y + y, min.z + z});
  }
  // Even vertices at the lower x.
  result.faces = {{0, 2, 4, 6}, {1, 3, 5, 7}, {0, 2, 3, 1}, {2, 4, 5, 3}, {4, 6, 7, 5}, {6, 0, 1, 7}};
  if (form == CubeForm::triangles) {
    std::vector<std::vector<std::uint32_t>> triangles;
    for (const auto& f : result.faces) {
      triangles.push_back({f[0], f[1], f[2]});
      triangles.push_back({f[0], f[2], f[3]});
    }
    result.faces = std::move(triangles);
  } else if (form == CubeForm::with_t_junction) {
    // The face at the lower x in two halves; the middle of its edge 0 - 2 is no vertex of the face beyond that edge.
    result.vertices.push_back({min.x, min.y + 1, min.z});
    result.faces[0] = {0, 8, 6};
    result.faces.push_back({8, 2, 4, 6});
  }
  return result;
}

}  // namespace occlude
