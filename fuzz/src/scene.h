// SPDX-License-Identifier: MIT
// A question that has no box yet.
#pragma once

#include <cstdint>
#include <vector>

#include "occlude/fuzz/cases.h"
#include "vector_math.h"

namespace occlude::fuzz {

/// Indices of vertices, in order.
using Loop = std::vector<std::uint32_t>;

struct Scene {
  kernel::Viewpoint viewpoint;
  std::vector<Vec3> vertices;  ///< of a polygon in order
  std::vector<Loop> faces;     ///< of a polytope, counter-clockwise seen from outside; a polygon has none
  Near near = Near::farthest;

  [[nodiscard]] bool is_polygon() const { return faces.empty(); }
};

}  // namespace occlude::fuzz
