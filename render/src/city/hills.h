// SPDX-License-Identifier: MIT
// English hills: fields between hedges and dry-stone walls, cottages, half-built houses, trees.
#pragma once

#include <cstddef>
#include <cstdint>

#include "builder.h"
#include "route.h"
#include "terrain.h"

namespace occlude::render::city {

/// The terrain for a model of `polygons` polygons: larger models have more hills, smaller ones coarser ground.
[[nodiscard]] Terrain make_terrain(std::uint64_t seed, std::size_t polygons);

/// Builds ground and lane, then what stands in the fields, until the model has at least `target` polygons.
void build_hills(Builder& b, std::uint64_t seed, const Route& route, const Terrain& terrain, std::size_t target);

}  // namespace occlude::render::city
