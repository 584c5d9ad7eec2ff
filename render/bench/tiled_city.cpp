// SPDX-License-Identifier: MIT
#include "tiled_city.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace occlude::experiments {
namespace {

/// Whole steps from a tile to the next, a little more than the city's extent. So moved coordinates stay exact but for the
/// last bits.
glm::dvec3 step_of(culler::SoupView soup) {
  glm::dvec3 low = soup.vertices[0], high = low;
  for (const glm::dvec3& v : soup.vertices) {
    low = glm::min(low, v);
    high = glm::max(high, v);
  }
  return {std::floor(high.x - low.x) + 1, std::floor(high.y - low.y) + 1, 0};
}

struct TilePlace {
  int x, y;
  [[nodiscard]] int ring() const { return std::max(std::abs(x), std::abs(y)); }
};

/// The places of so many tiles, from the middle outwards.
std::vector<TilePlace> places_of(std::size_t tiles) {
  int reach = 0;
  while (static_cast<std::size_t>(2 * reach + 1) * static_cast<std::size_t>(2 * reach + 1) < tiles) ++reach;
  std::vector<TilePlace> places;
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) places.push_back({x, y});
  }
  std::ranges::stable_sort(places, {}, &TilePlace::ring);
  places.resize(tiles);
  return places;
}

void append(culler::PolygonSoup& all, culler::SoupView tile, const glm::dvec3& offset) {
  const auto first_vertex = static_cast<std::uint32_t>(all.vertices.size());
  const auto first_index = static_cast<std::uint32_t>(all.indices.size());
  for (const glm::dvec3& v : tile.vertices) all.vertices.push_back(v + offset);
  for (const std::uint32_t v : tile.indices) all.indices.push_back(first_vertex + v);
  for (std::size_t p = 1; p < tile.first.size(); ++p) all.first.push_back(first_index + tile.first[p]);
}

}  // namespace

render::City tiled(const render::City& city, std::size_t polygons) {
  const culler::PolygonSoup& tile = city.soup;
  const std::size_t tiles = (polygons + tile.size() - 1) / tile.size();
  const glm::dvec3 step = step_of(tile);
  render::City all;
  all.path = city.path;
  all.soup.vertices.reserve(tiles * tile.vertices.size());
  all.soup.indices.reserve(tiles * tile.indices.size());
  all.soup.first.reserve(tiles * tile.size() + 1);
  for (const TilePlace& place : places_of(tiles)) append(all.soup, tile, step * glm::dvec3(place.x, place.y, 0));
  return all;
}

}  // namespace occlude::experiments
