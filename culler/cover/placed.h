// SPDX-License-Identifier: MIT
// Points and boxes of a mesh where it stands.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "occlude/culler/box.h"
#include "occlude/kernel/box_block.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// The point, with six roundings on each axis: three products and three sums.
[[nodiscard]] inline kernel::Vec3 placed(const Placement& at, const kernel::Vec3& p) {
  kernel::Vec3 result;
  for (int axis = 0; axis < 3; ++axis) {
    result[axis] = ((p.x * at.x[axis] + p.y * at.y[axis]) + p.z * at.z[axis]) + at.origin[axis];
  }
  return result;
}

/// An axis-aligned box that holds placed(at, p) for every point p of the box. Not finite if that overflows.
[[nodiscard]] inline kernel::Aabb placed(const Placement& at, const kernel::Aabb& box) {
  // Six roundings of a point, six of an end below and one where the end is moved outwards are 13. Each is at most 2^-53 of
  // the sum of the magnitudes, up to the rounding of that sum. The constant is 64 times 2^-53, more than four times as much.
  constexpr double kRounded = 0x1p-47;
  kernel::Aabb result;
  for (int axis = 0; axis < 3; ++axis) {
    double low = at.origin[axis], high = low, size = std::fabs(low);
    const double ends[3][2] = {{box.min.x, box.max.x}, {box.min.y, box.max.y}, {box.min.z, box.max.z}};
    const double columns[3] = {at.x[axis], at.y[axis], at.z[axis]};
    for (int k = 0; k < 3; ++k) {
      const double a = ends[k][0] * columns[k], b = ends[k][1] * columns[k];
      low += std::min(a, b);
      high += std::max(a, b);
      size += std::max(std::fabs(a), std::fabs(b));
    }
    result.min[axis] = low - kRounded * size;
    result.max[axis] = high + kRounded * size;
  }
  return result;
}

/// The boxes of a block where they stand, up to rounding: a few times as fast as one by one.
[[nodiscard]] inline kernel::BoxBlock nearly_placed(const Placement& at, const kernel::BoxBlock& boxes) {
  const kernel::Vec3* const columns[3] = {&at.x, &at.y, &at.z};
  kernel::BoxBlock result;
  for (int axis = 0; axis < 3; ++axis) {
    kernel::BoxBlock::Row low, high;
    low.fill(at.origin[axis]);
    high.fill(at.origin[axis]);
    for (std::size_t k = 0; k < 3; ++k) {
      const double factor = (*columns[k])[axis];
      const kernel::BoxBlock::Row& from = factor < 0 ? boxes.max[k] : boxes.min[k];
      const kernel::BoxBlock::Row& to = factor < 0 ? boxes.min[k] : boxes.max[k];
      for (std::size_t i = 0; i < kernel::BoxBlock::kBoxes; ++i) {
        low[i] += factor * from[i];
        high[i] += factor * to[i];
      }
    }
    result.min[static_cast<std::size_t>(axis)] = low;
    result.max[static_cast<std::size_t>(axis)] = high;
  }
  return result;
}

/// Up to rounding.
[[nodiscard]] inline double determinant(const kernel::Vec3& x, const kernel::Vec3& y, const kernel::Vec3& z) {
  const auto minor = [&](int i, int j) { return y[i] * z[j] - y[j] * z[i]; };
  return x.x * minor(1, 2) + x.y * minor(2, 0) + x.z * minor(0, 1);
}

/// Whether it turns what is seen counter-clockwise clockwise.
[[nodiscard]] inline bool is_mirrored(const Placement& at) { return determinant(at.x, at.y, at.z) < 0; }

}  // namespace occlude::culler
