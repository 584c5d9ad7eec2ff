// SPDX-License-Identifier: MIT
// The area of a polygon and the way it faces.
#pragma once

#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "occlude/culler/polygon_soup.h"

namespace occlude::render {

/// Newell's normal of a polygon: as long as twice its area, in model units squared. Rounded.
[[nodiscard]] inline glm::dvec3 doubled_area(culler::SoupView soup, std::size_t polygon) {
  const auto loop = soup.loop(polygon);
  const glm::dvec3 origin = soup.vertices[loop[0]];
  glm::dvec3 sum{0, 0, 0};
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    sum += glm::cross(soup.vertices[loop[i]] - origin, soup.vertices[loop[i + 1]] - origin);
  }
  return sum;
}

}  // namespace occlude::render
