// SPDX-License-Identifier: MIT
// Small integer geometry for brute-force checks. It is exact and uses none of the kernel's arithmetic.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "occlude/fuzz/random.h"
#include "occlude/kernel/types.h"

namespace lattice {

using Integer = std::int64_t;

struct Vector {
  Integer x = 0, y = 0, z = 0;

  friend bool operator==(const Vector&, const Vector&) = default;
};

inline Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector operator-(const Vector& a) { return {-a.x, -a.y, -a.z}; }
inline Vector operator*(Integer s, const Vector& v) { return {s * v.x, s * v.y, s * v.z}; }
inline Integer dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline Vector from_kernel(const occlude::kernel::Vec3& v) {
  return {static_cast<Integer>(v.x), static_cast<Integer>(v.y), static_cast<Integer>(v.z)};
}
inline occlude::kernel::Vec3 to_kernel(const Vector& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

inline Vector random_vector(occlude::fuzz::Random& random, int reach) {
  return {random.integer(-reach, reach), random.integer(-reach, reach), random.integer(-reach, reach)};
}

/// The map x -> origin + columns x.
struct AffineMap {
  Vector origin;
  std::array<Vector, 3> columns;

  static AffineMap random(occlude::fuzz::Random& random, int reach, int stretch) {
    const Vector origin = random_vector(random, reach);
    while (true) {
      const Vector a = random_vector(random, stretch), b = random_vector(random, stretch),
                   c = random_vector(random, stretch);
      if (dot(cross(a, b), c) != 0) return {origin, {a, b, c}};
    }
  }
  Vector operator()(const Vector& v) const { return origin + v.x * columns[0] + v.y * columns[1] + v.z * columns[2]; }
};

/// Convex polygons in the plane z = 0.
inline const std::vector<std::vector<Vector>>& polygons() {
  static const std::vector<std::vector<Vector>> all{
      {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}},
      {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}},
      {{0, -2, 0}, {2, -1, 0}, {1, 1, 0}, {-1, 2, 0}, {-2, 0, 0}},
      {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 0, 0}, {-1, -1, 0}, {0, -1, 0}},
      {{2, -1, 0}, {2, 1, 0}, {1, 2, 0}, {-1, 2, 0}, {-2, 1, 0}, {-2, -1, 0}, {-1, -2, 0}, {1, -2, 0}},
  };
  return all;
}

/// A tetrahedron, a cube, an octahedron, a prism and a pyramid.
inline const std::vector<occlude::kernel::Polytope>& polytopes() {
  static const std::vector<occlude::kernel::Polytope> all{
      {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}},
      {{{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}},
       {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}}},
      {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
       {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {0, 2, 5}, {2, 1, 5}, {1, 3, 5}, {3, 0, 5}}},
      {{{0, 0, -1}, {1, 0, -1}, {0, 1, -1}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}},
       {{0, 1, 2}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}},
      {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1}},
       {{0, 1, 2, 3}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}},
  };
  return all;
}

inline std::vector<occlude::kernel::Vec3> random_polygon(occlude::fuzz::Random& random, int reach) {
  const AffineMap map = AffineMap::random(random, reach, 2);
  std::vector<occlude::kernel::Vec3> loop;
  for (const Vector& v : polygons()[random.index(polygons().size())]) loop.push_back(to_kernel(map(v)));
  return loop;
}

inline occlude::kernel::Polytope random_polytope(occlude::fuzz::Random& random, int reach, int stretch) {
  const AffineMap map = AffineMap::random(random, reach, stretch);
  occlude::kernel::Polytope polytope = polytopes()[random.index(polytopes().size())];
  for (auto& v : polytope.vertices) v = to_kernel(map(from_kernel(v)));
  return polytope;
}

}  // namespace lattice
