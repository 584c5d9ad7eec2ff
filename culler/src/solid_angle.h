// SPDX-License-Identifier: MIT
// Criterion 1 of section 4: how large an occluder looks.
#pragma once

#include "frame_view.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/potential_occluders.h"

namespace occlude::culler {

/// The solid angle of a triangle seen from the origin, positive when it turns counter-clockwise, steradians (Van Oosterom
/// and Strackee 1983).
[[nodiscard]] double solid_angle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// How much the view has of occluder i: steradians, by the area-angle or exactly up to rounding; with parallel rays its
/// area as projected over the picture's.
[[nodiscard]] double seen_size(const PotentialOccluders& occluders, std::uint32_t i, const FrameView& view,
                               Objective::Angle angle);

}  // namespace occlude::culler
