// SPDX-License-Identifier: MIT
// A parish church in its churchyard.
#pragma once

#include "builder.h"
#include "random.h"

namespace occlude::render::city {

/// Walls, roof, tower and spire of a church whose yard is `yard`.
void build_church_shell(Builder& b, const Rect& yard);

/// Windows, buttresses, the yard's wall and its gravestones.
void build_church_details(Builder& b, const Rect& yard, Random random);

}  // namespace occlude::render::city
