// SPDX-License-Identifier: MIT
// The same polytope written down in another, legal way.
#pragma once

#include "occlude/fuzz/random.h"
#include "occlude/kernel/types.h"

namespace occlude::fuzz {

/// Faces in any sense and from any corner, vertices in any order.
void shuffle(Random& random, kernel::Polytope& polytope);

/// Faces cut into coplanar parts, corners on edges of the neighbour, collinear and repeated vertices. Midpoints are taken
/// three times at most: exact when all coordinates are multiples of eight.
void subdivide(Random& random, kernel::Polytope& polytope);

}  // namespace occlude::fuzz
