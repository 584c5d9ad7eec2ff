// SPDX-License-Identifier: MIT
// The triangles that a polygon of a model consists of, for the oracle.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

#include "occlude/culler/polygon_soup.h"
#include "occlude/oracle/ray.h"

namespace occlude::proof {

/// Calls f(triangle) for each triangle of the fan of a polygon.
template <class F>
void for_each_triangle(const culler::SoupView& soup, std::uint32_t polygon, const F& f) {
  const auto loop = soup.loop(polygon);
  const auto corner = [&](std::size_t i) {
    const glm::dvec3& v = soup.vertices[loop[i]];
    return oracle::Point{v.x, v.y, v.z};
  };
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) f(oracle::Triangle{corner(0), corner(i), corner(i + 1)});
}

}  // namespace occlude::proof
