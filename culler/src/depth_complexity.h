// SPDX-License-Identifier: MIT
// Criterion 2 of section 4: what occluders really hide, found out from sampled viewpoints.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "occlude/culler/hierarchy.h"
#include "occlude/culler/potential_occluders.h"

namespace occlude::culler {

/// An occluder and how many polygons it hides.
struct HiddenBy {
  std::uint32_t occluder;
  std::uint32_t polygons;
};

/// Which of the listed occluders, given in ascending order, hide most together as seen from a point, in all directions. They
/// are taken one by one, each time the one that hides most of what those before it leave, and only that counts for it: a
/// wall behind a wall hides nothing. A larger occluder that is not listed counts for its listed part. Looks at the occluders
/// that look largest, and at subtrees of the hierarchy as far as they look large; boxes not decided there count as not
/// hidden.
[[nodiscard]] std::vector<HiddenBy> best_together(const Hierarchy& hierarchy, const PotentialOccluders& occluders,
                                                  std::span<const std::uint32_t> listed, const glm::dvec3& eye);

}  // namespace occlude::culler
