// SPDX-License-Identifier: MIT
// Fitting an oriented box to polygons (section 3.1's OBBs).
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "occlude/culler/polygon_soup.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// Orthonormal up to rounding.
using BoxAxes = std::array<glm::dvec3, 3>;

/// A box along some axes, and half its surface.
struct Fit {
  BoxAxes axes;
  glm::dvec3 low{0, 0, 0}, high{0, 0, 0};  ///< along the axes
  double half_area = 0;
};

/// The smallest box along these axes, up to rounding.
[[nodiscard]] Fit fit_along(const BoxAxes& axes, SoupView soup, const PolygonRange& polygons);

/// The smallest of the boxes along the coordinate axes, and along an edge and the normal of the largest polygon, because
/// what is built stands along its walls.
[[nodiscard]] Fit fit_along_largest(SoupView soup, const PolygonRange& polygons);

/// The oriented box of the fit, widened until it holds every vertex of the polygons exactly. None if that takes too many
/// tries, or numbers beyond the kernel's legal range.
[[nodiscard]] std::optional<kernel::Obb> enclosing_box(const Fit& fit, SoupView soup, const PolygonRange& polygons);

}  // namespace occlude::culler
