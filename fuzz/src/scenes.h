// SPDX-License-Identifier: MIT
// Viewpoints and convex polygons, without a box. Lattice scenes have small integer coordinates and exactly coplanar
// polygons.
#pragma once

#include "occlude/fuzz/random.h"
#include "scene.h"

namespace occlude::fuzz {

/// Triangles, and polygons of 4 to 6 sides that are coplanar up to rounding (near `farthest`).
[[nodiscard]] Scene random_scene(Random& random);
/// A quadrilateral whose vertices are far from coplanar; near `farthest`.
[[nodiscard]] Scene folded_scene(Random& random);
/// 3 to 200 vertices on a circle, all at the same distance from the eye up to rounding; near `farthest`.
[[nodiscard]] Scene cospherical_scene(Random& random);
/// A triangle with an edge that points at the eye and misses it by very little. Numbers of twice the precision of a double
/// cannot resolve the plane through the edge and the eye.
[[nodiscard]] Scene edge_at_eye_scene(Random& random);
/// A quadrilateral whose vertices are in one plane with the eye, up to a few units in the last place.
[[nodiscard]] Scene level_with_eye_scene(Random& random);
/// A triangle 10^6 to 10^9 times longer than wide.
[[nodiscard]] Scene sliver_scene(Random& random);

[[nodiscard]] Scene lattice_scene(Random& random);
[[nodiscard]] Scene many_sided_scene(Random& random);
/// A polygon with extra vertices that lie on an edge or repeat the vertex before.
[[nodiscard]] Scene collinear_scene(Random& random);
/// Several vertices are at exactly the same, greatest distance; near `farthest`.
[[nodiscard]] Scene equal_farthest_scene(Random& random);
/// A triangle up to hundreds of times longer than wide.
[[nodiscard]] Scene lattice_sliver_scene(Random& random);
/// A polygon that stays legal when its coordinates are rounded. It is strictly convex with few sides, and near is `farthest`
/// unless it is a triangle.
[[nodiscard]] Scene sturdy_lattice_scene(Random& random);

/// The eye is close to a large polygon. Near is mostly `farthest`, and some rays do not meet that plane.
[[nodiscard]] Scene wide_scene(Random& random);
/// A rectangle or right triangle along two axes. It is seen along the third axis, or so that a side plane or a ray is
/// parallel to an axis.
[[nodiscard]] Scene axis_aligned_scene(Random& random);
[[nodiscard]] Scene orthographic_axis_aligned_scene(Random& random);
/// A triangle with integer coordinates of 24 bits.
[[nodiscard]] Scene large_lattice_scene(Random& random);
/// Random reals with edges along the axes, often an exact rectangle.
[[nodiscard]] Scene shared_coordinates_scene(Random& random);

[[nodiscard]] Scene orthographic_scene(Random& random);
[[nodiscard]] Scene orthographic_lattice_scene(Random& random);

[[nodiscard]] Near random_near(Random& random);

}  // namespace occlude::fuzz
