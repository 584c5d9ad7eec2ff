// SPDX-License-Identifier: MIT
// Which polygons look like one surface, such as the triangles of a wall, and what colour it has.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "occlude/culler/polygon_soup.h"

namespace occlude::render {

/// Of length one each, or zero without area.
[[nodiscard]] std::vector<glm::dvec3> unit_normals(culler::SoupView soup);

/// For each polygon the number of its surface. Polygons that share an edge, with a bend of at most 20 degrees between them,
/// are of one surface. Winding does not matter, and corners at the same place are one.
[[nodiscard]] std::vector<std::uint32_t> surfaces(culler::SoupView soup, const std::vector<glm::dvec3>& normals);

/// The colour of each polygon without light, in [0, 1]. Level ground and gentle slopes are grey, steeper ones roof
/// tiles, walls brick and stucco; polygons of one surface and one steepness have the same shade. It depends on the places of
/// the corners alone, so it is the same on every machine and in every order of the polygons.
[[nodiscard]] std::vector<glm::dvec3> surface_colours(culler::SoupView soup, const std::vector<glm::dvec3>& normals);

}  // namespace occlude::render
