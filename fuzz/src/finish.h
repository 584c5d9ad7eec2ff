// SPDX-License-Identifier: MIT
// Changes to a case after its box is placed.
#pragma once

#include "occlude/fuzz/cases.h"
#include "occlude/fuzz/random.h"

namespace occlude::fuzz {

void leave(Random& random, Case& made);

/// Makes one to three moves, each of one coordinate to the next double. The coordinates are those of the box, of the
/// viewpoint, and of an occluder that stays legal.
void nudge(Random& random, Case& made);

/// Puts a corner or the centre of the box or a vertex at the origin, and moves coordinates that are zero by 2^-40 to 2^-100.
/// This is so far below the last bits of the others that neither one double nor two hold the sums.
void move_by_a_hair(Random& random, Case& made);

/// Moves the case by 4e9, exactly. What was a small number becomes the last bits of a large one.
void move_far(Random& random, Case& made);

void shrink(Random& random, Case& made);
void grow(Random& random, Case& made);

/// Extends the box to one side: an axis-aligned box by 4 to 2 * 10^12, an oriented box by that many times a half edge. What
/// the other sides touched they still touch.
void lengthen(Random& random, Case& made);

/// Extends a flat oriented box along the direction of view, equally far both ways. Its position relative to the sides stays
/// the same.
void lengthen_along_rays(Random& random, Case& made);

/// Scales each axis by its own power of two, exactly, anywhere within the legal range. What touches still touches. REQUIRES:
/// all coordinates are integers below 2^20, and the viewpoint is an eye.
void stretch(Random& random, Case& made);

/// Multiplies every coordinate by 0.1 or divides it by 3, with rounding. What touched may be off by a rounding afterwards.
void make_decimal(Random& random, Case& made);

/// Write the polytope in another way (disguise.h): reorder() in another order, disguise() in every way. REQUIRES: for
/// disguise(), a lattice.
void reorder(Random& random, Case& made);
void disguise(Random& random, Case& made);

}  // namespace occlude::fuzz
