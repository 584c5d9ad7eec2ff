// SPDX-License-Identifier: MIT
// Viewpoints and convex polytopes, without a box. Lattice scenes have small integer coordinates and exactly plane faces.
#pragma once

#include "occlude/fuzz/random.h"
#include "scene.h"

namespace occlude::fuzz {

/// Tetrahedra with real coordinates, and hulls of points on an ellipsoid.
[[nodiscard]] Scene polytope_scene(Random& random);
[[nodiscard]] Scene orthographic_polytope_scene(Random& random);

/// A box, axis-aligned, oriented or skew.
[[nodiscard]] Scene lattice_box_scene(Random& random);
/// The hull of a few lattice points.
[[nodiscard]] Scene lattice_hull_scene(Random& random);
/// A box, a prism, a pyramid or a hull.
[[nodiscard]] Scene lattice_polytope_scene(Random& random);
[[nodiscard]] Scene orthographic_lattice_polytope_scene(Random& random);
/// The same with near `surface`.
[[nodiscard]] Scene lattice_surface_scene(Random& random);
[[nodiscard]] Scene many_sided_polytope_scene(Random& random);
/// The viewpoint is in the plane of a face or on the line of an edge, so that faces are seen edge-on.
[[nodiscard]] Scene edge_on_scene(Random& random);
[[nodiscard]] Scene orthographic_edge_on_scene(Random& random);
/// Half of these are seen edge-on. All faces are triangles, so the polytope stays convex when vertices are nudged.
[[nodiscard]] Scene simplicial_lattice_scene(Random& random);
[[nodiscard]] Scene orthographic_simplicial_lattice_scene(Random& random);
/// A prism or pyramid whose silhouette has several vertices at exactly the same, greatest distance; near `farthest`.
[[nodiscard]] Scene equal_farthest_polytope_scene(Random& random);
/// The eye is close to a large face. Near is mostly `farthest`, and some rays do not meet that plane.
[[nodiscard]] Scene wide_polytope_scene(Random& random);

}  // namespace occlude::fuzz
