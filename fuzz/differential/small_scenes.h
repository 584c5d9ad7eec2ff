// SPDX-License-Identifier: MIT
// Scenes of some dozens of polygons on a lattice, and cameras in odd places.
#pragma once

#include <glm/vec3.hpp>

#include "occlude/culler/camera.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/fuzz/random.h"

namespace occlude::fuzz {

/// The large things of a scene reach this far from the origin on each axis.
inline constexpr int kReach = 8;

/// A point of integers from -`reach` to `reach`.
[[nodiscard]] glm::dvec3 lattice_point(Random& random, int reach);

/// Some walls and boxes that hide, small things that they may hide, and a few polygons of any kind.
[[nodiscard]] culler::PolygonSoup some_soup(Random& random);

/// A camera near a vertex, mostly near one of the first wall. It may have a fault().
[[nodiscard]] culler::Camera some_camera(Random& random, culler::SoupView soup);

/// The matrix of a camera, as an engine of some kind makes it: a depth of either kind, reversed or not, without a far plane,
/// or with one where the camera has one. REQUIRES: the camera has no fault(). The matrix may have one.
[[nodiscard]] culler::MatrixCamera matrix_of(Random& random, const culler::Camera& camera);

}  // namespace occlude::fuzz
