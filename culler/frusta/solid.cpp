// SPDX-License-Identifier: MIT
#include "frusta/solid.h"

#include <cstddef>

#include "model/bounds.h"
#include "occlude/kernel/orientation.h"

namespace occlude::culler {
namespace {

using kernel::Aabb;
using kernel::Vec3;

/// Whether points lie strictly on one side of a plane, and strictly on the other.
struct PlaneSides {
  bool below = false, above = false;

  void add(int sign) {
    below |= sign < 0;
    above |= sign > 0;
  }
  /// Whether none is strictly on one of the sides, but some on the other.
  [[nodiscard]] bool is_one() const { return below != above; }
};

/// Whether the plane of the triangle has the open box on one side.
bool separates_plane(const std::array<Vec3, 3>& triangle, const Aabb& box) {
  PlaneSides sides;
  for (unsigned i = 0; i < 8 && !(sides.below && sides.above); ++i) {
    sides.add(kernel::orientation(triangle[0], triangle[1], triangle[2], corner(box, i)));
  }
  return sides.is_one();
}

/// Whether the plane through side u, v of a triangle and along the axis has the open box on one side, and the third corner w
/// not on this side.
bool separates_edge(int axis, const Vec3& u, const Vec3& v, const Vec3& w, const Aabb& box) {
  PlaneSides sides;
  for (unsigned i = 0; i < 8 && !(sides.below && sides.above); ++i) {
    const bool is_seen_before = (i >> static_cast<unsigned>(axis) & 1U) != 0;  // the corner less 1 along the axis
    if (!is_seen_before) sides.add(kernel::turn(axis, u, v, corner(box, i)));
  }
  if (!sides.is_one()) return false;
  const int third = kernel::turn(axis, u, v, w);
  return sides.above ? third <= 0 : third >= 0;
}

/// The sign of turn(0, p, a, b) for the point p moved by (0, e, e^2), with e as small as need be. The derivatives of the
/// turn by y and z of the point are a.z - b.z and b.y - a.y. So it is 0 only where a and b have the same y and z.
int moved_turn(const Vec3& p, const Vec3& a, const Vec3& b) {
  if (const int sign = kernel::turn(0, p, a, b); sign != 0) return sign;
  if (a.z != b.z) return a.z > b.z ? 1 : -1;
  return (b.y > a.y) - (b.y < a.y);
}

/// Whether the ray along x from the point moved so crosses the triangle. It meets no edge.
bool is_crossed(const SolidTriangle& triangle, const Vec3& point) {
  const Aabb& box = triangle.box;
  if (box.max.x <= point.x || box.max.y < point.y || box.min.y > point.y || box.max.z < point.z || box.min.z > point.z) {
    return false;
  }
  const auto& [a, b, c] = triangle.corners;
  const int sign = moved_turn(point, a, b);
  if (sign == 0 || moved_turn(point, b, c) != sign || moved_turn(point, c, a) != sign) return false;
  // The line crosses it. The normal, which turns as seen against x, tells where: it points along x if sign is 1. A point in
  // the plane would be on the triangle.
  return kernel::orientation(a, b, c, point) == -sign;
}

}  // namespace

Solid::Solid(SoupView soup, std::span<const std::uint32_t> polygons) : box(empty_box()) {
  for (const std::uint32_t p : polygons) {
    const std::span<const std::uint32_t> loop = soup.loop(p);
    const auto at = [&](std::size_t i) { return to_kernel(soup.vertices[loop[i]]); };
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      SolidTriangle& triangle = triangles.emplace_back(SolidTriangle{{at(0), at(i), at(i + 1)}, empty_box()});
      for (const Vec3& point : triangle.corners) grow(triangle.box, point);
      grow(box, triangle.box);
    }
  }
}

bool is_beside(const SolidTriangle& triangle, const Aabb& box) {
  for (int axis = 0; axis < 3; ++axis) {
    if (triangle.box.max[axis] <= box.min[axis] || triangle.box.min[axis] >= box.max[axis]) return true;
  }
  return false;
}

/// Two convex sets, one of them open, are disjoint if a plane has them on its two sides. If any has, one does that is along
/// a face of the box, or the triangle's, or along an edge of each.
bool meets_interior(const SolidTriangle& triangle, const Aabb& box) {
  const std::array<Vec3, 3>& t = triangle.corners;
  if (is_beside(triangle, box) || separates_plane(t, box)) return false;
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (separates_edge(axis, t[i], t[(i + 1) % 3], t[(i + 2) % 3], box)) return false;
    }
  }
  return true;
}

bool is_inside(const Solid& solid, const Vec3& point) {
  bool is_odd = false;
  for (const SolidTriangle& triangle : solid.triangles) is_odd ^= is_crossed(triangle, point);
  return is_odd;
}

}  // namespace occlude::culler
