// SPDX-License-Identifier: MIT
// What stands outdoors: trees, street furniture, and hedges, dry-stone walls and gates along any line over the hills.
#pragma once

#include "builder.h"
#include "random.h"
#include "terrain.h"

namespace occlude::render::city {

/// A tree standing at `foot`, from 5 to 9 m high: a trunk, a crown of two low-poly cones, and `leaves` upright
/// parallelograms as sprays of leaves.
void add_tree(Builder& b, const Point& foot, Length leaves, Random random);

/// A gas lamp, 3.6 m high.
void add_lamp(Builder& b, const Point& foot);

/// A bench in the frame, which runs along it.
void add_bench(Builder& b, const Frame& f);

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
