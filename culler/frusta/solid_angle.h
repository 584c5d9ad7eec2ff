// SPDX-License-Identifier: MIT
// Criterion 1 of section 4: how large an occluder looks.
#pragma once

#include "camera/frame_view.h"
#include "frusta/potential_occluders.h"
#include "occlude/culler/cull_result.h"

namespace occlude::culler {

/// The solid angle of a triangle seen from the origin, in steradians. It is positive if the triangle turns counter-clockwise
/// (Van Oosterom and Strackee 1983).
[[nodiscard]] double solid_angle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// How large occluder i looks: its solid angle in steradians, by the area-angle or exactly up to rounding. With parallel
/// rays, the share of the picture's area that its projection covers.
[[nodiscard]] double seen_size(const PotentialOccluders& occluders, std::uint32_t i, const FrameView& view,
                               Objective::Angle angle);

}  // namespace occlude::culler
