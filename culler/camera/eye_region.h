// SPDX-License-Identifier: MIT
// What a frame asks of the region that its eye may be in.
#pragma once

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

/// Whether everything within `error` of d is in the region, both relative to its middle. Rounding never makes it true. It
/// is false for all d but 0 if half-edges of the box are linearly dependent, or so nearly that nobody can tell.
[[nodiscard]] bool contains(const EyeRegion& eyes, const glm::dvec3& d, double error);

}  // namespace occlude::culler
