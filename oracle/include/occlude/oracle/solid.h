// SPDX-License-Identifier: MIT
// Whether a box or a triangle lies inside of a closed surface, and whether a triangle is half a face of a box.
#pragma once

#include <span>
#include <string>

#include "occlude/oracle/visibility.h"

namespace occlude::oracle {

/// Proves, in rational numbers, that the triangles are closed (every edge runs along an even number of their sides), that
/// none of them has a point in the box without its borders, and that a ray from the middle of the box, which meets no edge,
/// crosses an odd number of them. So the box lies inside of the surface. Returns an empty string when all of this holds,
/// else what failed. REQUIRES: finite numbers.
[[nodiscard]] std::string refute_inner_box(std::span<const Triangle> triangles, const Aabb& box);

/// Proves, likewise, that the triangles are closed, that none of them has a point in common with this one, borders included,
/// and that a corner of this one is inside. REQUIRES: finite numbers.
[[nodiscard]] std::string refute_inner_triangle(std::span<const Triangle> triangles, const Triangle& triangle);

/// Proves that the triangle is half a face of the box: its corners are three of the box's, on one face, counter-clockwise
/// seen from outside. Returns an empty string, else what failed. REQUIRES: finite numbers.
[[nodiscard]] std::string refute_half_face(const Aabb& box, const Triangle& triangle);

}  // namespace occlude::oracle
