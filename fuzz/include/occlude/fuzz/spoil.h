// SPDX-License-Identifier: MIT
// Cases that should be refused, and cases that only just should not.
#pragma once

#include "occlude/fuzz/case.h"
#include "occlude/fuzz/random.h"

namespace occlude::fuzz {

/// Damages the case in one way: a number at or beyond the border of the legal range; min above max; the eye in the occluder
/// or in its plane; a loop out of order, wound twice, with a spike or cut short; faces missing, doubled, dented, patched or
/// wrong; a direction of zero. The result may still be legal. REQUIRES: the case has vertices. A polytope has faces, and
/// they name existing vertices.
void spoil(Random& random, Case& c);

}  // namespace occlude::fuzz
