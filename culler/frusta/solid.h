// SPDX-License-Identifier: MIT
// A closed surface of triangles, and exact questions about what it encloses.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "occlude/culler/polygon_soup.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// A triangle as it is drawn, and the smallest box that holds it.
struct SolidTriangle {
  std::array<kernel::Vec3, 3> corners;
  kernel::Aabb box;
};

/// Every edge of the triangles runs along an even number of sides. So every point off the triangles is inside or outside: a
/// ray from it that crosses triangles, but no edge, crosses an odd or an even number of them, whichever ray it is.
struct Solid {
  std::vector<SolidTriangle> triangles;
  kernel::Aabb box;  ///< the smallest that holds them

  /// The fans of these polygons. REQUIRES: they are closed (closed_parts.h), and legal.
  Solid(SoupView soup, std::span<const std::uint32_t> polygons);
};

/// Whether a plane along a face of the box has the triangle, and the box without its borders, on its two sides.
[[nodiscard]] bool is_beside(const SolidTriangle& triangle, const kernel::Aabb& box);

/// Whether a point of the triangle, borders included, is in the box, borders excluded; exactly. REQUIRES: a legal box with
/// volume.
[[nodiscard]] bool meets_interior(const SolidTriangle& triangle, const kernel::Aabb& box);

/// Whether the legal point is inside of the solid, exactly, if it is on no triangle; else the answer means nothing.
[[nodiscard]] bool is_inside(const Solid& solid, const kernel::Vec3& point);

}  // namespace occlude::culler
