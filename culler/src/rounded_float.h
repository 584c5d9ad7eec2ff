// SPDX-License-Identifier: MIT
// Doubles as floats that are certainly no more, or no less.
#pragma once

#include <cmath>

namespace occlude::culler {

/// A float is out by half of an ulp, 2^-24 of a number or 2^-150 of the least ones: twice as much is taken away. REQUIRES: a
/// number that, as a float, is finite.
[[nodiscard]] inline float rounded_down(double x) { return static_cast<float>(x - (0x1p-23 * std::fabs(x) + 0x1p-149)); }

[[nodiscard]] inline float rounded_up(double x) { return -rounded_down(-x); }

}  // namespace occlude::culler
