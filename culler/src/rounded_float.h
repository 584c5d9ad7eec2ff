// SPDX-License-Identifier: MIT
// Doubles as floats that are certainly no more, or no less.
#pragma once

#include <cmath>
#include <limits>

namespace occlude::culler {

[[nodiscard]] inline float rounded_down(double x) {
  const auto nearest = static_cast<float>(x);
  return nearest <= x ? nearest : std::nextafter(nearest, -std::numeric_limits<float>::infinity());
}

[[nodiscard]] inline float rounded_up(double x) { return -rounded_down(-x); }

}  // namespace occlude::culler
