// SPDX-License-Identifier: MIT
// Cottages, finished and half-built.
#pragma once

#include "builder.h"
#include "random.h"

namespace occlude::render::city {

/// A cottage of 10 by 6 m; the frame's origin is the middle of its floor.
void build_cottage_shell(Builder& b, const Frame& f);
void build_cottage_details(Builder& b, const Frame& f, Random random);

/// The same house before its roof: walls of uneven height with an open doorway, bare rafters, a scaffold.
void build_unfinished_cottage(Builder& b, const Frame& f, Random random);

}  // namespace occlude::render::city
