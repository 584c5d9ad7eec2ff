// SPDX-License-Identifier: MIT
// An occluder as triangles: the fan of a polygon, or the fans of all faces of a polytope. The occluder hides what one of
// them hides.
#pragma once

#include <vector>

#include "points.h"

namespace occlude::oracle::second {

class Triangles {
 public:
  /// Triangles seen edge-on are left out, because every line of sight that meets one also meets an edge of another triangle.
  Triangles(const Viewpoint& view, const Occluder& occluder);

  /// Whether the line of sight to x, extended beyond x, meets a triangle.
  [[nodiscard]] bool are_in_line_with(const ExactPoint& x) const;

  /// Whether x lies on a triangle or behind one.
  [[nodiscard]] bool shade(const ExactPoint& x) const;

  /// Whether x lies behind a triangle.
  [[nodiscard]] bool hide(const ExactPoint& x) const;

 private:
  struct Triangle {
    ExactPoint a, b, c;
    CGAL::Orientation turn;
  };

  void add_fan(const Loop& loop);

  /// The side of the line from a to b on which x is seen: the sign of det(a - V, b - V, x - V), or det(d, b - a, x - a).
  [[nodiscard]] CGAL::Orientation side(const ExactPoint& a, const ExactPoint& b, const ExactPoint& x) const;
  [[nodiscard]] bool is_in_line(const Triangle& triangle, const ExactPoint& x) const;
  /// SMALLER when x is in front of the triangle's plane, EQUAL on it, LARGER beyond it.
  [[nodiscard]] CGAL::Comparison_result depth(const Triangle& triangle, const ExactPoint& x) const;

  Viewpoint view_;
  std::vector<Triangle> triangles_;
};

}  // namespace occlude::oracle::second
