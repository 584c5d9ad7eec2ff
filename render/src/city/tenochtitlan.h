// SPDX-License-Identifier: MIT
// A ceremonial centre on an island in a lake, after Tenochtitlan.
#pragma once

#include <cstddef>
#include <cstdint>

#include "builder.h"
#include "route.h"

namespace occlude::render::city {

/// Builds lake, island, precinct and pyramids, then detail, then islands of gardeners to the north and south, until the
/// model has at least `target` polygons.
void build_tenochtitlan(Builder& b, std::uint64_t seed, const Route& route, std::size_t target);

}  // namespace occlude::render::city
