// SPDX-License-Identifier: MIT
// Viewpoints and convex polygons, without a box yet. Lattice scenes have small integer coordinates and exactly coplanar
// polygons.
#pragma once

#include "occlude/fuzz/cases.h"
#include "occlude/fuzz/random.h"

namespace occlude::fuzz {

/// Triangles, and polygons of up to 6 sides that are coplanar only up to rounding (near `farthest`).
[[nodiscard]] Case random_scene(Random& random);
/// A quadrilateral whose vertices lie well off one plane; near `farthest`.
[[nodiscard]] Case folded_scene(Random& random);
/// A triangle a million to a thousand million times longer than wide.
[[nodiscard]] Case sliver_scene(Random& random);

[[nodiscard]] Case lattice_scene(Random& random);
[[nodiscard]] Case many_sided_scene(Random& random);
/// With vertices inserted that lie on an edge or repeat their predecessor.
[[nodiscard]] Case collinear_scene(Random& random);
/// Several vertices at exactly the same, greatest distance; near `farthest`.
[[nodiscard]] Case equal_farthest_scene(Random& random);
/// A triangle some hundred times longer than wide.
[[nodiscard]] Case lattice_sliver_scene(Random& random);
/// Rounding coordinates keeps it legal: strictly convex with few sides, and near `farthest` unless it is a triangle.
[[nodiscard]] Case sturdy_lattice_scene(Random& random);

[[nodiscard]] Case orthographic_scene(Random& random);
[[nodiscard]] Case orthographic_lattice_scene(Random& random);

}  // namespace occlude::fuzz
