// SPDX-License-Identifier: MIT
// Closed parts whose nearly flat regions are made flat, within the part.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "occlude/culler/executor.h"
#include "occlude/culler/polygon_soup.h"

namespace occlude::culler {

/// The triangles for a closed part (inner_boxes.h).
struct InsetPart {
  std::vector<std::uint32_t> polygons;  ///< of the part, ascending
  std::vector<std::array<glm::dvec3, 3>> triangles;
};

/// Triangles that hide for closed parts from outside of them: exactly inside of the part, turned as its polygons, and at
/// most half as many as its polygons need otherwise, `needed` of each. Of each region that is flat up to `inset`, a plane is
/// moved inwards until all of the region is beyond it; the triangles go from where these planes meet. That is up to
/// rounding, and may be anything. What counts is the proof: no triangle of the part, as it is drawn, has a point in common
/// with the new one, and a corner of that is inside. So all of it is. A part of which one triangle cannot be proven has
/// none. REQUIRES: a legal soup.
[[nodiscard]] std::vector<InsetPart> inset_parts(SoupView soup, double inset, std::span<const std::size_t> needed,
                                                 const Checkpoint& checkpoint);

}  // namespace occlude::culler
