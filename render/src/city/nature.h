// SPDX-License-Identifier: MIT
// Trees and street furniture.
#pragma once

#include "builder.h"
#include "random.h"

namespace occlude::render::city {

/// A tree standing at `foot`, from 4 to 9 m high: a trunk, a crown of low-poly cones, loose sprays of leaves as crossed
/// quads.
void add_tree(Builder& b, const Point& foot, Length leaves, Random random);

/// A gas lamp, 3.6 m high.
void add_lamp(Builder& b, const Point& foot);

/// A bench along a frame.
void add_bench(Builder& b, const Frame& f);

}  // namespace occlude::render::city
