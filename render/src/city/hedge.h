// SPDX-License-Identifier: MIT
// Hedges, dry-stone walls and gates along any line over the hills.
#pragma once

#include "builder.h"
#include "random.h"
#include "terrain.h"

namespace occlude::render::city {

/// A straight piece of boundary from `a` to `b` (on the ground), `thickness` to its left, `height` high.
struct Boundary {
  Point a, b;
  Length thickness, height;
  bool stone;
};

/// The inside of the hedge or wall: two upright faces, a top and ends.
void build_boundary_core(Builder& b, const Boundary& boundary);

/// Leaves or stones standing proud of the faces.
void build_boundary_details(Builder& b, const Boundary& boundary, Random random);

/// A gate of five bars from `a` to `b`.
void build_gate(Builder& builder, const Point& a, const Point& b);

}  // namespace occlude::render::city
