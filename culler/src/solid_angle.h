// SPDX-License-Identifier: MIT
// Criterion 1 of section 4: how large an occluder looks.
#pragma once

#include "occlude/culler/camera.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/potential_occluders.h"

namespace occlude::culler {

/// The solid angle of a triangle seen from the origin, positive when it turns counter-clockwise, steradians (Van Oosterom
/// and Strackee 1983).
[[nodiscard]] double solid_angle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// How much the camera sees of occluder i: steradians, by the area-angle or exactly up to rounding; with parallel rays its
/// area as projected over the picture's.
[[nodiscard]] double seen_size(const PolygonSoup& soup, const PotentialOccluders& occluders, std::uint32_t i,
                               const Camera& camera, const glm::dvec3& forward, Objective::Angle angle);

}  // namespace occlude::culler
