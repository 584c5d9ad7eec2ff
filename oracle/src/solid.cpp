// SPDX-License-Identifier: MIT
#include "occlude/oracle/solid.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace occlude::oracle {
namespace {

using Rational = CGAL::Exact_rational;
using RationalVector = CGAL::Simple_cartesian<Rational>::Vector_3;

RationalVector rational(const Point& p) { return {Rational(p[0]), Rational(p[1]), Rational(p[2])}; }

bool is_closed(std::span<const Triangle> triangles) {
  std::map<std::pair<Point, Point>, std::size_t> sides;
  for (const Triangle& triangle : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      Point a = triangle[i], b = triangle[(i + 1) % 3];
      if (a == b) continue;
      if (b < a) std::swap(a, b);
      ++sides[{a, b}];
    }
  }
  return std::ranges::all_of(sides, [](const auto& side) { return side.second % 2 == 0; });
}

/// The part of a convex polygon where sign * (x[axis] - bound) <= 0.
std::vector<RationalVector> clipped(const std::vector<RationalVector>& polygon, int axis, const Rational& bound, int sign) {
  std::vector<RationalVector> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const RationalVector &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const Rational a = sign * (p[axis] - bound), b = sign * (q[axis] - bound);
    if (a <= 0) result.push_back(p);
    if ((a < 0 && b > 0) || (a > 0 && b < 0)) result.push_back(p + (a / (a - b)) * (q - p));
  }
  return result;
}

/// Whether the triangle has a point in the box without its borders. Where its part in the closed box has one, the mean of
/// the corners of this part is one, too.
bool comes_into(const Triangle& triangle, const Aabb& box) {
  std::vector<RationalVector> part{rational(triangle[0]), rational(triangle[1]), rational(triangle[2])};
  for (std::size_t axis = 0; axis < 3 && !part.empty(); ++axis) {
    part = clipped(part, static_cast<int>(axis), Rational(box.max[axis]), 1);
    part = clipped(part, static_cast<int>(axis), Rational(box.min[axis]), -1);
  }
  if (part.empty()) return false;
  RationalVector mean(0, 0, 0);
  for (const RationalVector& corner : part) mean = mean + corner / Rational(static_cast<int>(part.size()));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Rational& x = mean[static_cast<int>(axis)];
    if (x <= Rational(box.min[axis]) || x >= Rational(box.max[axis])) return false;
  }
  return true;
}

/// How many triangles the ray crosses; none where its line meets an edge.
std::optional<std::size_t> crossed(std::span<const Triangle> triangles, const RationalVector& from,
                                   const RationalVector& direction) {
  std::size_t count = 0;
  for (const Triangle& triangle : triangles) {
    const std::array<RationalVector, 3> to{rational(triangle[0]) - from, rational(triangle[1]) - from,
                                           rational(triangle[2]) - from};
    if (CGAL::cross_product(to[1] - to[0], to[2] - to[0]) == CGAL::NULL_VECTOR) continue;  // a ray close by misses it
    std::array<int, 3> signs{};
    for (std::size_t i = 0; i < 3; ++i) {
      signs[i] = CGAL::sign(direction * CGAL::cross_product(to[i], to[(i + 1) % 3]));
    }
    if (std::ranges::count(signs, 1) > 0 && std::ranges::count(signs, -1) > 0) continue;
    if (std::ranges::count(signs, 0) > 0) return std::nullopt;
    if (CGAL::sign(to[0] * CGAL::cross_product(to[1], to[2])) == signs[0]) ++count;
  }
  return count;
}

/// Whether the point, which is on none of the triangles, is inside.
std::string refute_inside(std::span<const Triangle> triangles, const RationalVector& point, const std::string& what) {
  for (int i = 1; i < 100; ++i) {  // some direction misses all edges, unless there are degenerate triangles everywhere
    const RationalVector direction(Rational(i * i * 7919), Rational(i * 104729 + 31), Rational(1299709 - i * 17));
    if (const auto count = crossed(triangles, point, direction)) return *count % 2 == 1 ? "" : what + " is outside";
  }
  return "no ray misses all edges";
}

bool has_no_area(const Triangle& t) {
  return CGAL::cross_product(rational(t[1]) - rational(t[0]), rational(t[2]) - rational(t[0])) == CGAL::NULL_VECTOR;
}

/// Whether they have a point in common. The first has an area; the second may be a segment or a point.
bool meet(const Triangle& triangle, const Triangle& other) {
  using Geometry = CGAL::Simple_cartesian<Rational>;
  const auto at = [](const Point& p) { return CGAL::ORIGIN + rational(p); };
  const Geometry::Triangle_3 first(at(triangle[0]), at(triangle[1]), at(triangle[2]));
  if (!has_no_area(other)) return CGAL::do_intersect(first, Geometry::Triangle_3(at(other[0]), at(other[1]), at(other[2])));
  const auto [low, high] = std::ranges::minmax(other);  // the ends, in the order of coordinates
  return low == high ? first.has_on(at(low)) : CGAL::do_intersect(first, Geometry::Segment_3(at(low), at(high)));
}

}  // namespace

std::string refute_inner_box(std::span<const Triangle> triangles, const Aabb& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(box.min[axis] < box.max[axis])) return "the box is flat";
  }
  if (!is_closed(triangles)) return "the surface is not closed";
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (comes_into(triangles[i], box)) return "triangle " + std::to_string(i) + " comes into the box";
  }
  return refute_inside(triangles, (rational(box.min) + rational(box.max)) / Rational(2), "the box");
}

std::string refute_inner_triangle(std::span<const Triangle> triangles, const Triangle& triangle) {
  if (!is_closed(triangles)) return "the surface is not closed";
  if (has_no_area(triangle)) return "the triangle has no area";
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (meet(triangle, triangles[i])) return "triangle " + std::to_string(i) + " meets it";
  }
  return refute_inside(triangles, rational(triangle[0]), "the triangle");
}

std::string refute_half_face(const Aabb& box, const Triangle& triangle) {
  const auto is_corner = [&](const Point& p) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (p[axis] != box.min[axis] && p[axis] != box.max[axis]) return false;
    }
    return true;
  };
  if (!std::ranges::all_of(triangle, is_corner)) return "not between corners of the box";
  const auto& [a, b, c] = triangle;
  const RationalVector normal = CGAL::cross_product(rational(b) - rational(a), rational(c) - rational(a));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (a[axis] != b[axis] || b[axis] != c[axis]) continue;
    const int outwards = a[axis] == box.max[axis] ? 1 : -1;
    return normal[static_cast<int>(axis)] * outwards > 0 ? "" : "turned inwards";
  }
  return "on no face of the box";
}

}  // namespace occlude::oracle
