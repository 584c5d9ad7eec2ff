// SPDX-License-Identifier: MIT
// Single buildings: a church, a railway viaduct, cottages, stepped pyramids. The shell of a building contains its occluders;
// details follow as far as the number of polygons allows.
#pragma once

#include "builder.h"
#include "random.h"

namespace occlude::render::city {

/// Walls, roof, tower and spire of a church whose yard is `yard`.
void build_church_shell(Builder& b, const Rect& yard);

/// Windows, buttresses, the yard's wall and its gravestones.
void build_church_details(Builder& b, const Rect& yard, Random random);

/// Walls and deck of a viaduct `length` long. Its front face starts at the origin of the frame and faces `out`.
void build_viaduct_shell(Builder& b, const Frame& f, Length length);

/// Bricked-up arches, piers, cornice and parapet.
void build_viaduct_details(Builder& b, const Frame& f, Length length);

/// A cottage of 10 by 6 m; the frame's origin is the middle of its floor.
void build_cottage_shell(Builder& b, const Frame& f);
void build_cottage_details(Builder& b, const Frame& f, Random random);

/// The same house before its roof: walls of uneven height with an open doorway, bare rafters, a scaffold.
void build_unfinished_cottage(Builder& b, const Frame& f, Random random);

/// A pyramid in a frame: its front foot runs along from -width/2 to width/2 at out = 0, its body lies behind.
struct Pyramid {
  Frame frame;
  Length width, depth;
  Length tiers, tier_height;
  Length flights;  ///< stairs side by side up the front, one temple at the head of each
};

/// Tiers with battered walls and the temples.
void build_pyramid_shell(Builder& b, const Pyramid& p);

/// Stairs, each step cut into `stones`, with their balustrades.
void build_stairs(Builder& b, const Pyramid& p, Length stones);

}  // namespace occlude::render::city
