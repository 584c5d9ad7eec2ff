// SPDX-License-Identifier: MIT
// Exact numbers, the roundoff of doubles, and shares of bounds.
#pragma once

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace occlude::bound_check {

using Exact = CGAL::Exact_rational;

/// The relative error of an operation on doubles is at most this.
inline const Exact kRoundoff = Exact(std::numeric_limits<double>::epsilon()) / 2;

/// The square root, up to a share of less than 2^-200: two steps of Newton's method from a double. REQUIRES: x >= 0, and
/// that x as a double does not underflow.
[[nodiscard]] inline Exact root(const Exact& x) {
  if (x == 0) return 0;
  Exact y = std::sqrt(CGAL::to_double(x));
  for (int step = 0; step < 2; ++step) y = (y + x / y) / 2;
  return y;
}

/// |value - true value| / bound. An error without a bound is an infinite share. What exceeds its bound by however little has
/// a share above 1.
[[nodiscard]] inline double share(const Exact& off, const Exact& bound) {
  if (off <= 0 && bound >= 0) return 0;
  if (bound <= 0) return std::numeric_limits<double>::infinity();
  const double rounded = CGAL::to_double(Exact(off / bound));
  return off > bound ? std::max(rounded, std::nextafter(1.0, 2.0)) : std::min(rounded, 1.0);
}

/// The share of a bound that is known by what it leaves: `room` without errors, `left` with those that occurred.
[[nodiscard]] inline double share_used(const Exact& room, const Exact& left) { return share(room - left, room); }

}  // namespace occlude::bound_check
