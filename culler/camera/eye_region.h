// SPDX-License-Identifier: MIT
// What a frame asks of the region that its eye may be in.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <string_view>

#include "occlude/culler/camera.h"

namespace occlude::culler {

/// Why the region cannot be used; empty if it can.
[[nodiscard]] std::string_view fault(const EyeRegion& eyes);

/// No eye of the region is farther from its middle.
[[nodiscard]] inline double radius_of(const EyeRegion& eyes) {
  double radius = eyes.radius;
  for (const glm::dvec3& half_edge : eyes.half_edges) radius += glm::length(half_edge);
  return radius;
}

}  // namespace occlude::culler
