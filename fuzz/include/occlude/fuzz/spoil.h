// SPDX-License-Identifier: MIT
// Cases that ought to be refused, and cases that only just ought not to.
#pragma once

#include "occlude/fuzz/case.h"
#include "occlude/fuzz/random.h"

namespace occlude::fuzz {

/// Damages the case in one way: a number at or beyond the border of the legal range, min above max, the eye in the occluder
/// or in its plane, a loop out of order, wound twice, spiked or cut short, faces missing, doubled, dented, patched or wrong,
/// no direction. What comes out may still be legal. REQUIRES: the case has vertices and, of a polytope, faces of existing
/// ones.
void spoil(Random& random, Case& c);

}  // namespace occlude::fuzz
