// SPDX-License-Identifier: MIT
// Random vectors, and convex polygons with small integer coordinates.
#pragma once

#include <cstdint>
#include <vector>

#include "occlude/fuzz/random.h"
#include "vector_math.h"

namespace occlude::fuzz {

/// A vector of integers in [-reach, reach].
[[nodiscard]] Vec3 lattice_vector(Random& random, int reach);
/// A vector of numbers in [-reach, reach).
[[nodiscard]] Vec3 random_vector(Random& random, double reach);

/// An edge of a polygon in the plane.
struct Step {
  int a = 0, b = 0;
};

[[nodiscard]] inline std::int64_t cross(const Step& p, const Step& q) {
  return std::int64_t{p.a} * q.b - std::int64_t{p.b} * q.a;
}

/// The edges of a convex polygon of about `count` sides, sorted by angle.
[[nodiscard]] std::vector<Step> lattice_edges(Random& random, int count, int reach);
/// The same with about three to six short edges.
[[nodiscard]] std::vector<Step> few_edges(Random& random);

/// The polygon with these edges in a random lattice plane.
[[nodiscard]] std::vector<Vec3> embed(Random& random, const std::vector<Step>& steps);

/// A normal of the plane of a coplanar polygon.
[[nodiscard]] Vec3 plane_normal(const std::vector<Vec3>& polygon);

}  // namespace occlude::fuzz
