// SPDX-License-Identifier: MIT
// Criterion 2 of section 4: what occluders really hide, measured at sampled viewpoints.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "frusta/potential_occluders.h"
#include "occlude/culler/hierarchy.h"

namespace occlude::culler {

/// An occluder and how many polygons it hides.
struct HiddenBy {
  std::uint32_t occluder;
  std::uint32_t polygons;
};

/// Which of the listed occluders, given in ascending order, hide most together as seen from a point, in all directions. They
/// are taken one by one. Each time the one is taken that hides most of what is left, and only that counts for it, because a
/// wall behind a wall hides nothing. A larger occluder that is not listed counts for its listed part. Only the occluders
/// that look largest are considered. Subtrees that look small are not descended into, and a box that stays undecided there
/// counts as not hidden.
[[nodiscard]] std::vector<HiddenBy> best_together(const Hierarchy& hierarchy, const PotentialOccluders& occluders,
                                                  std::span<const std::uint32_t> listed, const glm::dvec3& eye);

}  // namespace occlude::culler
