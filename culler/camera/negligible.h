// SPDX-License-Identifier: MIT
// Directions in numbers that are legal for the kernel.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>

namespace occlude::culler {

/// Components of normals and of the line of sight that are smaller than this share of their length are dropped, so that all
/// numbers stay within the kernel's legal range. The share is far below the 2^-53 by which rounding turns the vectors.
inline constexpr double kNegligible = 0x1p-60;

/// REQUIRES: a length of 1, up to rounding.
[[nodiscard]] inline glm::dvec3 without_negligible(glm::dvec3 v) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::fabs(v[axis]) < kNegligible) v[axis] = 0;
  }
  return v;
}

}  // namespace occlude::culler
