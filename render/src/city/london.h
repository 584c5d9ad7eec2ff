// SPDX-License-Identifier: MIT
// Streets of terraces round courtyards, garden squares and churches.
#pragma once

#include <cstddef>
#include <cstdint>

#include "builder.h"
#include "route.h"

namespace occlude::render::city {

/// Builds London until the model has at least `target` polygons: first the shells of the whole core, then one layer of
/// detail after another over all its houses, then suburbs.
void build_london(Builder& b, std::uint64_t seed, const Route& route, std::size_t target);

}  // namespace occlude::render::city
