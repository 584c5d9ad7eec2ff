// SPDX-License-Identifier: MIT
// Half-spaces of a view in numbers that are legal for the kernel.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>

#include "occlude/culler/camera.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {

/// A plane with a larger offset than this is farther from the origin than any point.
inline constexpr double kFarthestPlane = 0x1p103;

/// The same half-space, or a slightly larger one, in numbers that are legal for the kernel. Coordinates up to 2^100 have
/// offsets up to 2^103, and what is left of an offset after cancellation may be arbitrarily small. REQUIRES: an offset of
/// at most twice kFarthestPlane.
[[nodiscard]] inline HalfSpace legal(const glm::dvec3& normal, double offset) {
  if (std::fabs(offset) > kernel::kMaxMagnitude) return {normal * 0x1p-4, offset * 0x1p-4};
  if (offset != 0 && std::fabs(offset) < kernel::kMinMagnitude) return {normal, kernel::kMinMagnitude};
  return {normal, offset};
}

}  // namespace occlude::culler
