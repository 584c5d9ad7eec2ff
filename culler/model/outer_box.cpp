// SPDX-License-Identifier: MIT
#include "model/outer_box.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace occlude::culler {
namespace {

/// A double that is not below the exact number that `x` was rounded from. x is the double nearest to that number, so the
/// number is less than the next double up. Nothing overflows, because the numbers of a box are at most 2^100. This is a call
/// less than std::nextafter().
double up(double x) {
  if (x == 0) return std::numeric_limits<double>::denorm_min();
  const auto bits = std::bit_cast<std::int64_t>(x);
  return std::bit_cast<double>(x > 0 ? bits + 1 : bits - 1);
}
double down(double x) { return -up(-x); }

/// The largest number in the kernel's legal range, or 0, that is not above x. REQUIRES: x is not beyond the range.
double legal_below(double x) {
  if (std::fabs(x) >= kernel::kMinMagnitude) return x;
  return x < 0 ? -kernel::kMinMagnitude : 0;
}
double legal_above(double x) { return -legal_below(-x); }

kernel::Aabb around(const kernel::Aabb& box) {
  kernel::Aabb result;
  for (int axis = 0; axis < 3; ++axis) {
    result.min[axis] = legal_below(box.min[axis]);
    result.max[axis] = legal_above(box.max[axis]);
  }
  return result;
}

/// On each axis, an oriented box reaches as far from its centre as its half edges together. Every sum is rounded outwards.
kernel::Aabb around(const kernel::Obb& box) {
  kernel::Aabb result;
  for (int axis = 0; axis < 3; ++axis) {
    const auto reach = [&](std::size_t edge) { return std::fabs(box.half_edges[edge][axis]); };
    const double half = up(up(reach(0) + reach(1)) + reach(2));
    result.min[axis] = legal_below(down(box.center[axis] - half));
    result.max[axis] = legal_above(up(box.center[axis] + half));
  }
  return result;
}

}  // namespace

kernel::Aabb outer_box(const Box& box) {
  return std::visit([](const auto& b) { return around(b); }, box);
}

}  // namespace occlude::culler
