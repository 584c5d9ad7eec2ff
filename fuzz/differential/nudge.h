// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "occlude/fuzz/case.h"
#include "occlude/fuzz/random.h"

namespace occlude::fuzz {

/// Moves one coordinate of one vertex by an ulp.
inline void nudge(Random& random, Polygon& polygon) {
  double& x = polygon[random.index(polygon.size())][random.integer(0, 2)];
  x = std::nextafter(x, random.chance(0.5) ? HUGE_VAL : -HUGE_VAL);
}

}  // namespace occlude::fuzz
