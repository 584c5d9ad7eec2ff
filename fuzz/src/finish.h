// SPDX-License-Identifier: MIT
// What is done to a case once its box is placed.
#pragma once

#include "occlude/fuzz/cases.h"
#include "occlude/fuzz/random.h"

namespace occlude::fuzz {

void leave(Random& random, Case& made);

/// Moves coordinates of the box, of the viewpoint, or of an occluder that stays legal, to a neighbouring double or the one
/// after it.
void nudge(Random& random, Case& made);

/// Puts a corner of the box or a vertex at the origin and moves coordinates that are zero by 2^-40 to 2^-100, far below the
/// last bits of the others: sums that no double holds, nor two.
void move_by_a_hair(Random& random, Case& made);

/// Exactly, by a few thousand million: what was a small number becomes the last bits of a large one.
void move_far(Random& random, Case& made);

void shrink(Random& random, Case& made);
void grow(Random& random, Case& made);

/// Draws the box out to one side, four to a million million times: what touches with the others still does.
void lengthen(Random& random, Case& made);

/// Draws a flat oriented box out along the direction of view, to both sides as far: it lies to the sides as it did.
void lengthen_along_rays(Random& random, Case& made);

/// Scales each axis by itself, exactly, anywhere within the legal range: what touches still touches. Of integers below 2^20,
/// for an eye.
void stretch(Random& random, Case& made);

/// Rounds every coordinate as decimal input or thirds do: what touched is now off by a rounding or not.
void make_decimal(Random& random, Case& made);

/// The polytope written down in another way (disguise.h): the order alone, or all of it, on a lattice.
void reorder(Random& random, Case& made);
void disguise(Random& random, Case& made);

}  // namespace occlude::fuzz
