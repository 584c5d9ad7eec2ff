// SPDX-License-Identifier: MIT
// The polygons as OpenGL receives them.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "occlude/culler/polygon_soup.h"
#include "projection.h"

namespace occlude::render {

/// One corner of a triangle. Corners are not shared through an index buffer: llvmpipe draws many short ranges about 10 %
/// faster without one, even for quads.
struct Corner {
  std::array<float, 3> position;  ///< relative to the list's centre
  std::uint32_t polygon;
};
static_assert(sizeof(Corner) == 16);

/// The fan triangulations of all polygons, three corners per triangle.
struct TriangleList {
  glm::dvec3 centre{0, 0, 0};
  Extent extent;  ///< of the vertices, in model space
  std::vector<Corner> corners;
  std::vector<std::uint32_t> first = {0};  ///< polygon p owns corners [first[p], first[p + 1])
};

/// Throws std::runtime_error for more triangles than OpenGL can number.
[[nodiscard]] TriangleList make_triangle_list(culler::SoupView soup);

}  // namespace occlude::render
