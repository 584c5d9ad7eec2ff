// SPDX-License-Identifier: MIT
// Scenes of some dozens of polygons on a lattice, and cameras in odd places of them.
#pragma once

#include <glm/vec3.hpp>

#include "occlude/culler/camera.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/fuzz/random.h"

namespace occlude::fuzz {

/// How far a scene's large things reach from the origin, on each axis.
inline constexpr int kReach = 8;

/// Whole numbers up to `reach`.
[[nodiscard]] glm::dvec3 lattice_point(Random& random, int reach);

/// Some walls and boxes that hide, small things that can be hidden, and a few polygons of any kind.
[[nodiscard]] culler::PolygonSoup some_soup(Random& random);

/// Near a vertex, mostly of the first wall; it may have a fault().
[[nodiscard]] culler::Camera some_camera(Random& random, const culler::PolygonSoup& soup);

}  // namespace occlude::fuzz
