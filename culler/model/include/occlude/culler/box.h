// SPDX-License-Identifier: MIT
// Boxes, and where things stand. Reading order: 3.
#pragma once

#include <cstddef>
#include <string_view>
#include <variant>

#include "occlude/kernel/types.h"

namespace occlude::culler {

/// An axis-aligned or an oriented box. It is legal if kernel::check(box) == Refusal::none (occlude/kernel/validity.h).
using Box = std::variant<kernel::Aabb, kernel::Obb>;

/// Why a scene refuses the box: a number that is NaN, or min > max. Empty if it takes it. A box that a scene takes need not
/// be legal.
[[nodiscard]] std::string_view fault(const Box& box);

/// An affine map: the point p of a mesh is at p.x x + p.y y + p.z z + origin in the scene. The columns need be neither unit
/// vectors nor perpendicular, so a mesh may be scaled, sheared and mirrored.
struct Placement {
  kernel::Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  kernel::Vec3 origin{0, 0, 0};

  /// From a matrix of sixteen numbers, column after column, as MatrixCamera::from_columns() has them. Throws
  /// std::invalid_argument if the matrix is not affine: its last row is not (0, 0, 0, 1). REQUIRES: `numbers` points to 16
  /// numbers.
  template <class Number>
  [[nodiscard]] static Placement from_columns(const Number* numbers) {
    return from(numbers, 4, 1);
  }
  /// From sixteen numbers, row after row: the transpose of the above. Throws and REQUIRES: as above.
  template <class Number>
  [[nodiscard]] static Placement from_rows(const Number* numbers) {
    return from(numbers, 1, 4);
  }

  friend bool operator==(const Placement&, const Placement&) = default;

 private:
  template <class Number>
  [[nodiscard]] static Placement from(const Number* numbers, std::size_t column, std::size_t row) {
    const auto at = [&](std::size_t r, std::size_t c) { return static_cast<double>(numbers[r * row + c * column]); };
    const auto vector = [&](std::size_t c) -> kernel::Vec3 { return {at(0, c), at(1, c), at(2, c)}; };
    require_affine(at(3, 0), at(3, 1), at(3, 2), at(3, 3));
    return {vector(0), vector(1), vector(2), vector(3)};
  }
  /// Throws if this is not the last row of an affine matrix.
  static void require_affine(double x, double y, double z, double w);
};

/// A box in the scene that holds the placed image of each point of the box, exact or rounded as doubles are. It is oriented
/// if that is tighter: where axes are turned, and no edge is nearly in the plane of the others. REQUIRES: finite numbers.
[[nodiscard]] Box placed_box(const kernel::Aabb& box, const Placement& at);

}  // namespace occlude::culler
