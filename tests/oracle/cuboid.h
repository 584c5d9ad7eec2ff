// SPDX-License-Identifier: MIT
// A box as a polytope.
#pragma once

#include "occlude/oracle/oracle.h"

namespace occlude::oracle {

/// Vertex i is at the high end of axis k when bit k of i is set. The faces are low and high x, low and high y, low and high
/// z.
inline Polytope cuboid(const Point& min, const Point& max) {
  Polytope result{{}, {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}}};
  for (unsigned i = 0; i < 8; ++i) {
    const auto at = [&](unsigned axis) { return (i >> axis & 1U) != 0 ? max[axis] : min[axis]; };
    result.vertices.push_back({at(0), at(1), at(2)});
  }
  return result;
}

}  // namespace occlude::oracle
