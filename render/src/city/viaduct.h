// SPDX-License-Identifier: MIT
// A brick railway viaduct, which closes the view where the town ends.
#pragma once

#include "builder.h"

namespace occlude::render::city {

/// Walls and deck of a viaduct `length` long; its front face starts in the origin of the frame and faces `out`.
void build_viaduct_shell(Builder& b, const Frame& f, Length length);

/// Bricked-up arches, piers, cornice and parapet.
void build_viaduct_details(Builder& b, const Frame& f, Length length);

}  // namespace occlude::render::city
