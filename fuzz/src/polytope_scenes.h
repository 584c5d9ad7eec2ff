// SPDX-License-Identifier: MIT
// Viewpoints and convex polytopes, without a box yet. Lattice scenes have small integer coordinates and exactly plane faces.
#pragma once

#include "occlude/fuzz/random.h"
#include "scene.h"

namespace occlude::fuzz {

/// Real tetrahedra and hulls of points on an ellipsoid.
[[nodiscard]] Scene polytope_scene(Random& random);
[[nodiscard]] Scene orthographic_polytope_scene(Random& random);

/// A box, axis-aligned, oriented or skew.
[[nodiscard]] Scene lattice_box_scene(Random& random);
/// Hulls of few lattice points.
[[nodiscard]] Scene lattice_hull_scene(Random& random);
/// Boxes, prisms, pyramids, hulls.
[[nodiscard]] Scene lattice_polytope_scene(Random& random);
[[nodiscard]] Scene orthographic_lattice_polytope_scene(Random& random);
/// Near `surface`.
[[nodiscard]] Scene lattice_surface_scene(Random& random);
[[nodiscard]] Scene many_sided_polytope_scene(Random& random);
/// The viewpoint in the plane of a face or on the line of an edge, so that faces are seen edge-on.
[[nodiscard]] Scene edge_on_scene(Random& random);
[[nodiscard]] Scene orthographic_edge_on_scene(Random& random);
/// Half of them seen edge-on; only triangles, so that nudged vertices leave it convex.
[[nodiscard]] Scene simplicial_lattice_scene(Random& random);
[[nodiscard]] Scene orthographic_simplicial_lattice_scene(Random& random);
/// A prism or pyramid with several vertices of its silhouette at the same, greatest distance; near `farthest`.
[[nodiscard]] Scene equal_farthest_polytope_scene(Random& random);
/// The eye close to a large face; mostly near `farthest`, whose plane is then behind some rays.
[[nodiscard]] Scene wide_polytope_scene(Random& random);

}  // namespace occlude::fuzz
