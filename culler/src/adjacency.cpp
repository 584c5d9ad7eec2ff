// SPDX-License-Identifier: MIT
#include "occlude/culler/adjacency.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <glm/geometric.hpp>
#include <numeric>

namespace occlude::culler {
namespace {

/// Of each vertex the first with the same coordinates.
std::vector<std::uint32_t> welded(const std::vector<glm::dvec3>& vertices) {
  std::vector<std::uint32_t> order(vertices.size()), result(vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto coordinates = [&](std::uint32_t i) { return std::array{vertices[i].x, vertices[i].y, vertices[i].z}; };
  std::ranges::sort(order, {}, [&](std::uint32_t i) { return std::pair{coordinates(i), i}; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_same = i > 0 && coordinates(order[i]) == coordinates(order[i - 1]);
    result[order[i]] = is_same ? result[order[i - 1]] : order[i];
  }
  return result;
}

struct Side {
  std::uint32_t low, high;  ///< welded vertices
  std::uint32_t side;
  bool ascends;

  auto operator<=>(const Side&) const = default;
};

std::vector<Side> sides_of(const PolygonSoup& soup) {
  const std::vector<std::uint32_t> weld = welded(soup.vertices);
  std::vector<Side> sides;
  sides.reserve(soup.indices.size());
  for (std::size_t p = 0; p < soup.size(); ++p) {
    const std::uint32_t first = soup.first[p], end = soup.first[p + 1];
    for (std::uint32_t s = first; s < end; ++s) {
      const std::uint32_t a = weld[soup.indices[s]], b = weld[soup.indices[s + 1 < end ? s + 1 : first]];
      if (a != b) sides.push_back({std::min(a, b), std::max(a, b), s, a < b});
    }
  }
  return sides;
}

}  // namespace

std::vector<std::uint32_t> polygon_of_sides(const PolygonSoup& soup) {
  std::vector<std::uint32_t> polygon_of(soup.indices.size());
  for (std::uint32_t p = 0; p < soup.size(); ++p) {
    std::fill_n(polygon_of.begin() + soup.first[p], soup.loop(p).size(), p);
  }
  return polygon_of;
}

std::vector<SidePair> find_adjacency(const PolygonSoup& soup) {
  std::vector<Side> sides = sides_of(soup);
  std::ranges::sort(sides);
  std::vector<SidePair> pairs;
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    const Side& side = sides[i];
    while (end < sides.size() && sides[end].low == side.low && sides[end].high == side.high) ++end;
    if (end - i != 2 || side.ascends == sides[i + 1].ascends) continue;
    const glm::dvec3 edge = soup.vertices[side.high] - soup.vertices[side.low];
    pairs.push_back({glm::dot(edge, edge), side.side, sides[i + 1].side});
  }
  std::ranges::stable_sort(pairs, std::ranges::greater(), &SidePair::length);
  return pairs;
}

}  // namespace occlude::culler
