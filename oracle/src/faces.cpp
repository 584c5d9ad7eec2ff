// SPDX-License-Identifier: MIT
#include "occlude/oracle/faces.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace occlude::oracle {
namespace {

using Rational = CGAL::Exact_rational;
using Geometry = CGAL::Simple_cartesian<Rational>;
using Place = Geometry::Point_2;
using Piece = std::vector<Place>;  ///< a convex polygon, counter-clockwise

Geometry::Point_3 rational(const Point& p) { return {Rational(p[0]), Rational(p[1]), Rational(p[2])}; }

Geometry::Vector_3 normal(const Triangle& triangle) {
  const auto a = rational(triangle[0]);
  return CGAL::cross_product(rational(triangle[1]) - a, rational(triangle[2]) - a);
}

/// The plane of a triangle with area, as it is seen along an axis from the side from which the triangle is
/// counter-clockwise.
class Sheet {
 public:
  explicit Sheet(const Triangle& triangle) : normal_(normal(triangle)), origin_(rational(triangle[0])) {
    while (axis_ < 2 && normal_[axis_] == 0) ++axis_;
  }

  /// Whether the triangle lies in the plane and turns that way.
  [[nodiscard]] bool has(const Triangle& triangle) const {
    const auto is_on = [&](const Point& p) { return normal_ * (rational(p) - origin_) == 0; };
    return std::ranges::all_of(triangle, is_on) && normal(triangle)[axis_] * normal_[axis_] > 0;
  }

  [[nodiscard]] Piece seen(const Triangle& triangle) const {
    Piece piece;
    for (const Point& p : triangle) {
      const Rational x(p[(at(1))]), y(p[at(2)]);
      piece.push_back(normal_[axis_] > 0 ? Place(x, y) : Place(y, x));
    }
    return piece;
  }

 private:
  [[nodiscard]] std::size_t at(int step) const { return static_cast<std::size_t>((axis_ + step) % 3); }

  Geometry::Vector_3 normal_;
  Geometry::Point_3 origin_;
  int axis_ = 0;
};

/// How far p lies on the left of the line from a to b.
Rational left(const Place& a, const Place& b, const Place& p) {
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

/// The part of the piece on the left of the line from a to b; none if it has no area.
Piece left_part(const Piece& piece, const Place& a, const Place& b) {
  Piece result;
  bool has_area = false;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const Place &p = piece[i], &q = piece[(i + 1) % piece.size()];
    const Rational at_p = left(a, b, p), at_q = left(a, b, q);
    if (at_p >= 0) result.push_back(p);
    if (at_p > 0) has_area = true;
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) result.push_back(p + (at_p / (at_p - at_q)) * (q - p));
  }
  return has_area ? result : Piece();
}

/// Adds what is left of the piece without the triangle to `left`.
void cut_out(const Piece& triangle, const Piece& piece, std::vector<Piece>& left) {
  std::vector<Piece> outside;
  Piece inside = piece;
  for (std::size_t i = 0; i < 3; ++i) {
    const Place &a = triangle[i], &b = triangle[(i + 1) % 3];
    if (Piece beyond = left_part(inside, b, a); !beyond.empty()) outside.push_back(beyond);
    inside = left_part(inside, a, b);
    if (inside.empty()) return left.push_back(piece);
  }
  left.insert(left.end(), outside.begin(), outside.end());
}

}  // namespace

std::string refute_on_faces(std::span<const Triangle> faces, const Triangle& triangle) {
  if (std::ranges::find(faces, triangle) != faces.end()) return "";
  if (normal(triangle) == CGAL::NULL_VECTOR) return "a triangle without area is none of the faces";
  const auto beside = [&](const Triangle& face) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::array<double, 3> at{triangle[0][axis], triangle[1][axis], triangle[2][axis]};
      const auto is_below = [&](const Point& p) { return p[axis] < std::ranges::min(at); };
      const auto is_above = [&](const Point& p) { return p[axis] > std::ranges::max(at); };
      if (std::ranges::all_of(face, is_below) || std::ranges::all_of(face, is_above)) return true;
    }
    return false;
  };
  const Sheet sheet(triangle);
  std::vector<Piece> pieces{sheet.seen(triangle)}, left;
  std::size_t in_plane = 0;
  for (const Triangle& face : faces) {
    if (beside(face) || !sheet.has(face)) continue;
    ++in_plane;
    left.clear();
    for (const Piece& piece : pieces) cut_out(sheet.seen(face), piece, left);
    pieces.swap(left);
    if (pieces.empty()) return "";
  }
  return in_plane == 0 ? "no face lies in its plane and turns its way" : "a part of it is on no face";
}

}  // namespace occlude::oracle
