// SPDX-License-Identifier: MIT
// Convex polytopes with every face turned outwards and no vertex twice. On integer points everything is exact.
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

/// The hull of up to 32 points. It tries every plane through three of them. The hull of coplanar points has no faces.
[[nodiscard]] Solid hull(const std::vector<Vec3>& points);

/// The solid with a corner and the three edges from it.
[[nodiscard]] Solid parallelepiped(const Vec3& corner, const Frame& edges);
/// The solid between a polygon and its copy moved by `way`. REQUIRES: `way` is not parallel to the plane of the polygon.
[[nodiscard]] Solid prism(const std::vector<Vec3>& base, const Vec3& way);
/// The lower half of a pyramid, between its base and the section of half the size. The pyramid is twice as large as that of
/// `base` and `apex`.
[[nodiscard]] Solid truncated_pyramid(const std::vector<Vec3>& base, const Vec3& apex);
[[nodiscard]] Solid pyramid(const std::vector<Vec3>& base, const Vec3& apex);
/// The solid with an apex on each side of the polygon. REQUIRES: the line between them goes through the interior of the
/// polygon.
[[nodiscard]] Solid bipyramid(const std::vector<Vec3>& base, const Vec3& apex, const Vec3& other_apex);

/// An axis-aligned, oriented or skew box.
[[nodiscard]] Solid lattice_box(Random& random);
/// The hull of four to `most` points.
[[nodiscard]] Solid lattice_hull(Random& random, int most);
/// A box, a prism, a pyramid or a hull of a few points. Its coordinates are integers below about a hundred.
[[nodiscard]] Solid lattice_solid(Random& random);
/// A prism, pyramid or similar solid over a polygon of up to 64 sides.
[[nodiscard]] Solid many_sided_solid(Random& random);
/// All faces are triangles and no two are coplanar, so the solid stays convex when its vertices move a little.
[[nodiscard]] Solid simplicial_lattice_solid(Random& random);
/// The same with real coordinates: a tetrahedron, or the hull of 5 to 8 points on an ellipsoid.
[[nodiscard]] Solid simplicial_solid(Random& random);

/// A vector that is not parallel to the polygon's plane.
[[nodiscard]] Vec3 way_off(Random& random, const std::vector<Vec3>& base, int reach);

}  // namespace occlude::fuzz
