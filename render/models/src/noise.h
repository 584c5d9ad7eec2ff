// SPDX-License-Identifier: MIT
// What rounding leaves of zero.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>
#include <initializer_list>

#include "model_check.h"
#include "occlude/kernel/validity.h"

namespace occlude::render {

/// Sets the numbers to 0 that are nearer to it than any legal one, and no more than the rounding of the largest number of
/// these vectors. Returns how many.
inline std::size_t drop_noise(std::initializer_list<glm::dvec3*> vectors) {
  double largest = 0;
  for (const glm::dvec3* v : vectors) largest = std::max({largest, std::fabs(v->x), std::fabs(v->y), std::fabs(v->z)});
  std::size_t dropped = 0;
  if (!(largest * 0x1p-53 >= kernel::kMinMagnitude)) return dropped;
  for (glm::dvec3* v : vectors) dropped += drop_tiny(*v);
  return dropped;
}

}  // namespace occlude::render
