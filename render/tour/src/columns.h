// SPDX-License-Identifier: MIT
// A grid of upright columns, and the columns that a triangle goes through.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace occlude::render {

/// Columns of width `cell` from (x, y); column (i, j) has number j nx + i.
struct Columns {
  double x = 0, y = 0, cell = 1;
  std::uint32_t nx = 0, ny = 0;

  [[nodiscard]] std::size_t size() const { return std::size_t{nx} * ny; }
  [[nodiscard]] glm::dvec2 middle(std::uint32_t column) const {
    return {x + cell * (column % nx + 0.5), y + cell * (column / nx + 0.5)};
  }
};

/// A convex piece of a triangle.
struct Piece {
  // Four lines cut a triangle to at most seven corners. Rounding may dent a piece, so that it gets more.
  std::array<glm::dvec3, 16> corners;
  std::size_t count = 0;

  void add(const glm::dvec3& corner) {
    if (count < corners.size()) corners[count++] = corner;
  }
  /// The least or the largest of a coordinate. REQUIRES: count > 0.
  [[nodiscard]] double least(int axis) const {
    double value = corners[0][axis];
    for (std::size_t i = 1; i < count; ++i) value = std::min(value, corners[i][axis]);
    return value;
  }
  [[nodiscard]] double largest(int axis) const {
    double value = corners[0][axis];
    for (std::size_t i = 1; i < count; ++i) value = std::max(value, corners[i][axis]);
    return value;
  }
};

/// Takes what lies at or below `at` on the axis from the piece, and leaves what lies at or above.
inline Piece take_below(Piece& piece, int axis, double at) {
  Piece below, above;
  for (std::size_t i = 0; i < piece.count; ++i) {
    const glm::dvec3 &a = piece.corners[i], &b = piece.corners[i + 1 < piece.count ? i + 1 : 0];
    if (a[axis] <= at) below.add(a);
    if (a[axis] >= at) above.add(a);
    if ((a[axis] < at && b[axis] > at) || (a[axis] > at && b[axis] < at)) {
      glm::dvec3 middle = a + (at - a[axis]) / (b[axis] - a[axis]) * (b - a);
      middle[axis] = at;
      below.add(middle);
      above.add(middle);
    }
  }
  piece = above;
  return below;
}

/// Calls visit(k, part) for each strip k < count of width `cell` from `start` on the axis that the piece goes through.
template <class Visit>
void for_each_strip(Piece piece, int axis, double start, double cell, std::uint32_t count, Visit&& visit) {
  const auto strip = [&](double at) { return std::floor((at - start) / cell); };
  const double first = strip(piece.least(axis)), last = strip(piece.largest(axis));
  if (last < 0 || first >= count) return;
  if (first < 0) take_below(piece, axis, start);
  const auto end = static_cast<std::uint32_t>(std::min(last, count - 1.0));
  for (auto k = static_cast<std::uint32_t>(std::max(first, 0.0)); piece.count > 0 && k <= end; ++k) {
    const Piece part = k < last ? take_below(piece, axis, start + cell * (k + 1)) : piece;
    if (part.count > 0) visit(k, part);
  }
}

/// Calls visit(column, low, high) for each column that the triangle goes through, with the heights between which it does.
template <class Visit>
void for_each_column(const Columns& columns, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, Visit&& visit) {
  Piece triangle;
  for (const glm::dvec3* corner : {&a, &b, &c}) triangle.add(*corner);
  for_each_strip(triangle, 1, columns.y, columns.cell, columns.ny, [&](std::uint32_t j, const Piece& row) {
    for_each_strip(row, 0, columns.x, columns.cell, columns.nx, [&](std::uint32_t i, const Piece& part) {
      visit(std::size_t{j} * columns.nx + i, part.least(2), part.largest(2));
    });
  });
}

/// About how many cells of a grid of squares, or cubes, a triangle with this area and circumference goes through.
inline double cells_of(double area, double circumference, double cell) {
  return area / (cell * cell) + circumference / cell + 1;
}

}  // namespace occlude::render
