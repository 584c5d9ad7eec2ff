// SPDX-License-Identifier: MIT
// The model in coordinates of its own: z is up, and the origin is the middle of its box.
#pragma once

#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "occlude/culler/polygon_soup.h"

namespace occlude::render {

struct Place {
  /// REQUIRES: as make_tour().
  Place(culler::SoupView model, const glm::dvec3& up);

  culler::SoupView soup;
  glm::dvec3 origin{};               ///< in the model
  std::array<glm::dvec3, 3> axes{};  ///< of the place, in the model: right-handed, orthonormal up to rounding
  std::vector<glm::dvec3> points;    ///< the vertices of the soup
  glm::dvec3 low{}, high{};          ///< the box of all polygons
  double radius = 0;                 ///< half the diagonal of the box, or a little more; never 0
  double eye_height = 0;             ///< never 0

  [[nodiscard]] glm::dvec3 in_model(const glm::dvec3& p) const {
    return origin + (p.x * axes[0] + p.y * axes[1] + p.z * axes[2]);
  }
  [[nodiscard]] glm::dvec3 size() const { return high - low; }

  /// Calls visit(a, b, c) for each triangle that is drawn.
  template <class Visit>
  void for_each_triangle(Visit&& visit) const {
    for (std::size_t p = 0; p < soup.size(); ++p) {
      const std::span<const std::uint32_t> loop = soup.loop(p);
      for (std::size_t i = 1; i + 1 < loop.size(); ++i) visit(points[loop[0]], points[loop[i]], points[loop[i + 1]]);
    }
  }
};

}  // namespace occlude::render
