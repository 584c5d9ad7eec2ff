// SPDX-License-Identifier: MIT
// Viewpoints and convex polygons, without a box yet. Lattice scenes have small integer coordinates and exactly coplanar
// polygons.
#pragma once

#include "occlude/fuzz/random.h"
#include "scene.h"

namespace occlude::fuzz {

/// Triangles, and polygons of up to 6 sides that are coplanar only up to rounding (near `farthest`).
[[nodiscard]] Scene random_scene(Random& random);
/// A quadrilateral whose vertices lie well off one plane; near `farthest`.
[[nodiscard]] Scene folded_scene(Random& random);
/// 3 to 200 vertices on a circle, all at the same distance from the eye but for rounding; near `farthest`.
[[nodiscard]] Scene cospherical_scene(Random& random);
/// A triangle with an edge that points at the eye but for so little that the plane through both is beyond twice the
/// precision of a double.
[[nodiscard]] Scene edge_at_eye_scene(Random& random);
/// A quadrilateral whose vertices lie in one plane with the eye but for a few units in the last place.
[[nodiscard]] Scene level_with_eye_scene(Random& random);
/// A triangle a million to a thousand million times longer than wide.
[[nodiscard]] Scene sliver_scene(Random& random);

[[nodiscard]] Scene lattice_scene(Random& random);
[[nodiscard]] Scene many_sided_scene(Random& random);
/// With vertices inserted that lie on an edge or repeat their predecessor.
[[nodiscard]] Scene collinear_scene(Random& random);
/// Several vertices at exactly the same, greatest distance; near `farthest`.
[[nodiscard]] Scene equal_farthest_scene(Random& random);
/// A triangle some hundred times longer than wide.
[[nodiscard]] Scene lattice_sliver_scene(Random& random);
/// Rounding coordinates keeps it legal: strictly convex with few sides, and near `farthest` unless it is a triangle.
[[nodiscard]] Scene sturdy_lattice_scene(Random& random);

/// The eye close to a large polygon; mostly near `farthest`, whose plane is then behind some rays.
[[nodiscard]] Scene wide_scene(Random& random);
/// A rectangle or right triangle along two axes, seen along a third, or from a side plane or a ray parallel to an axis.
[[nodiscard]] Scene axis_aligned_scene(Random& random);
[[nodiscard]] Scene orthographic_axis_aligned_scene(Random& random);
/// A triangle of integers of 24 bits.
[[nodiscard]] Scene large_lattice_scene(Random& random);
/// Random reals, with edges along the axes; often an exact rectangle.
[[nodiscard]] Scene shared_coordinates_scene(Random& random);

[[nodiscard]] Scene orthographic_scene(Random& random);
[[nodiscard]] Scene orthographic_lattice_scene(Random& random);

[[nodiscard]] Near random_near(Random& random);

}  // namespace occlude::fuzz
