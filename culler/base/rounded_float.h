// SPDX-License-Identifier: MIT
// Doubles rounded to floats that are certainly not larger, or not smaller.
#pragma once

#include <cmath>

namespace occlude::culler {

/// Rounding to a float changes a number by at most half an ulp: 2^-24 of it, or 2^-150 for the least numbers. Twice that is
/// subtracted. REQUIRES: x is finite as a float.
[[nodiscard]] inline float rounded_down(double x) { return static_cast<float>(x - (0x1p-23 * std::fabs(x) + 0x1p-149)); }

[[nodiscard]] inline float rounded_up(double x) { return -rounded_down(-x); }

}  // namespace occlude::culler
