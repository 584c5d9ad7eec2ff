// SPDX-License-Identifier: MIT
// Convex polytopes: every face turned outwards, no vertex twice. On integer points everything is exact.
#pragma once

#include <vector>

#include "frames.h"
#include "occlude/fuzz/random.h"
#include "scene.h"

namespace occlude::fuzz {

struct Solid {
  std::vector<Vec3> vertices;
  std::vector<Loop> faces;
};

/// The hull of up to 32 points, by trying every plane through three of them. A flat hull has no faces.
[[nodiscard]] Solid hull(const std::vector<Vec3>& points);

/// A corner and the edges from it.
[[nodiscard]] Solid parallelepiped(const Vec3& corner, const Frame& edges);
/// Between a polygon and its copy moved by `way`, which leaves the polygon's plane.
[[nodiscard]] Solid prism(const std::vector<Vec3>& base, const Vec3& way);
/// The part of a pyramid between its base and a copy of half the size; twice as large as the polygon and the apex given.
[[nodiscard]] Solid truncated_pyramid(const std::vector<Vec3>& base, const Vec3& apex);
[[nodiscard]] Solid pyramid(const std::vector<Vec3>& base, const Vec3& apex);
/// With an apex on either side of the polygon; the line between them goes through its interior.
[[nodiscard]] Solid bipyramid(const std::vector<Vec3>& base, const Vec3& apex, const Vec3& other_apex);

/// Axis-aligned, oriented or skew.
[[nodiscard]] Solid lattice_box(Random& random);
/// Of four to `most` points.
[[nodiscard]] Solid lattice_hull(Random& random, int most);
/// Of whole coordinates below about a hundred, boxes, prisms, pyramids and hulls of few points.
[[nodiscard]] Solid lattice_solid(Random& random);
/// A prism, pyramid or the like over a polygon of up to 64 sides.
[[nodiscard]] Solid many_sided_solid(Random& random);
/// All faces are triangles, no two coplanar: moving the vertices a little keeps it convex.
[[nodiscard]] Solid simplicial_lattice_solid(Random& random);
/// The same of real coordinates: a tetrahedron, or the hull of 5 to 8 points on an ellipsoid.
[[nodiscard]] Solid simplicial_solid(Random& random);

/// A vector off the polygon's plane.
[[nodiscard]] Vec3 way_off(Random& random, const std::vector<Vec3>& base, int reach);

}  // namespace occlude::fuzz
