// SPDX-License-Identifier: MIT
// The three parts of the city. Each builds until the model has at least `target` polygons.
#pragma once

#include <cstddef>
#include <cstdint>

#include "builder.h"
#include "route.h"
#include "terrain.h"

namespace occlude::render::city {

/// Streets of terraces round courtyards, garden squares and churches: first the shells of the whole core, then one layer of
/// detail after another over all its houses, then suburbs.
void build_london(Builder& b, std::uint64_t seed, const Route& route, std::size_t target);

/// A ceremonial centre on an island in a lake, after Tenochtitlan: lake, island, precinct and pyramids, then detail, then
/// islands of gardeners to the north and south.
void build_tenochtitlan(Builder& b, std::uint64_t seed, const Route& route, std::size_t target);

/// The terrain for a model of `polygons` polygons: larger models have more hills, smaller ones coarser ground.
[[nodiscard]] Terrain make_terrain(std::uint64_t seed, std::size_t polygons);

/// English hills: ground and lane, then what stands in the fields: hedges and dry-stone walls, cottages, half-built houses,
/// trees.
void build_hills(Builder& b, std::uint64_t seed, const Route& route, const Terrain& terrain, std::size_t target);

}  // namespace occlude::render::city
