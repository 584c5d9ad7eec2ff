// SPDX-License-Identifier: MIT
// Stepped pyramids.
#pragma once

#include "builder.h"

namespace occlude::render::city {

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
