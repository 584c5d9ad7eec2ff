// SPDX-License-Identifier: MIT
// Disjoint triangles have a plane between them, and it can be turned until it meets three of their corners.
#include "simplify/triangles_apart.h"

#include <array>
#include <cstddef>

#include "occlude/kernel/orientation.h"

namespace occlude::culler {
namespace {

using kernel::Vec3;
using TriangleCorners = std::array<Vec3, 3>;

/// Whether a plane through `a`, or through a side of it and a corner of `b`, has the triangles on its two sides, all but
/// these strictly.
bool is_plane_between(const TriangleCorners& a, const TriangleCorners& b) {
  const int above = kernel::orientation(a[0], a[1], a[2], b[0]);
  const auto side = [&](std::size_t k) { return kernel::orientation(a[0], a[1], a[2], b[k]); };
  if (above != 0 && side(1) == above && side(2) == above) return true;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &u = a[i], &v = a[(i + 1) % 3], &w = a[(i + 2) % 3];
    for (std::size_t k = 0; k < 3; ++k) {
      const int own = kernel::orientation(u, v, b[k], w);
      if (own != 0 && kernel::orientation(u, v, b[k], b[(k + 1) % 3]) == -own &&
          kernel::orientation(u, v, b[k], b[(k + 2) % 3]) == -own) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

bool are_apart(const SolidTriangle& a, const SolidTriangle& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (a.box.max[axis] < b.box.min[axis] || b.box.max[axis] < a.box.min[axis]) return true;
  }
  return is_plane_between(a.corners, b.corners) || is_plane_between(b.corners, a.corners);
}

}  // namespace occlude::culler
