// SPDX-License-Identifier: MIT
// The three districts put together.
//
// The soup has the flaws of hand-made models on purpose: party walls that exist twice (exact duplicates), polygons that
// overlap in one plane (the end of one terrace against the back of another), slivers (railings), solids that intersect
// (chimneys and roofs, tower and nave, stairs and pyramids). Parallel surfaces in different planes are at least 3 cm apart,
// so that none of them flickers at a distance.
#include "occlude/render/city.h"

#include "builder.h"
#include "parts.h"
#include "route.h"
#include "terrain.h"

namespace occlude::render {

City generate_city(std::size_t polygons, std::uint64_t seed) {
  using namespace city;
  City result;
  const Terrain terrain = make_terrain(seed, polygons);
  const Route route(terrain);
  result.path = film(route, terrain);

  Builder builder(result.soup);
  result.soup.first.reserve(polygons + polygons / 10);
  result.soup.indices.reserve(polygons * 4 + polygons / 10 * 4);
  result.soup.vertices.reserve(polygons * 4);
  // 15 % each for the ceremonial centre and the hills. London comes last: its detail can stop after any house, so the model
  // has few polygons more than requested.
  build_tenochtitlan(builder, seed, route, polygons * 15 / 100);
  build_hills(builder, seed, route, terrain, polygons * 30 / 100);
  build_london(builder, seed, route, polygons);
  return result;
}

}  // namespace occlude::render
