// SPDX-License-Identifier: MIT
// Writes the same polytope in another legal way.
#pragma once

#include "occlude/fuzz/random.h"
#include "occlude/kernel/types.h"

namespace occlude::fuzz {

/// Turns faces inwards or outwards, starts them at any corner and lists the vertices in any order.
void shuffle(Random& random, kernel::Polytope& polytope);

/// Cuts faces into coplanar parts, puts corners on edges of neighbours, and adds collinear and repeated vertices. At most
/// three midpoints are taken, perhaps of other midpoints, so this is exact when all coordinates are multiples of eight.
void subdivide(Random& random, kernel::Polytope& polytope);

}  // namespace occlude::fuzz
