// SPDX-License-Identifier: MIT
#include "model/adjacency.h"

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <glm/geometric.hpp>
#include <numeric>

#include "base/parallel_sort.h"

namespace occlude::culler {
namespace {

struct Side {
  std::uint32_t low, high;  ///< welded vertices
  std::uint32_t side;
  bool ascends;

  auto operator<=>(const Side&) const = default;
};

std::vector<Side> sides_of(SoupView soup, std::span<const std::uint32_t> weld, const Checkpoint& checkpoint) {
  std::vector<Side> sides;
  sides.reserve(soup.indices.size());
  for (std::size_t p = 0; p < soup.size(); ++p) {
    checkpoint.at(p);
    if (!soup.is_opaque(p)) continue;
    const std::uint32_t first = soup.first[p], end = soup.first[p + 1];
    for (std::uint32_t s = first; s < end; ++s) {
      const std::uint32_t a = weld[soup.indices[s]], b = weld[soup.indices[s + 1 < end ? s + 1 : first]];
      if (a != b) sides.push_back({std::min(a, b), std::max(a, b), s, a < b});
    }
  }
  return sides;
}

/// The corners of a polygon in an order that depends neither on where its loop begins nor on its orientation: it starts at
/// the least corner and goes on to the lesser of its two neighbours.
class Corners {
 public:
  Corners(std::span<const std::uint32_t> loop, std::span<const std::uint32_t> weld) : loop_(loop), weld_(weld) {
    const auto at = [&](std::uint32_t i) { return weld[i]; };
    first_ = static_cast<std::size_t>(std::ranges::min_element(loop, {}, at) - loop.begin());
    goes_back_ = vertex(1) > vertex(size() - 1);
  }

  [[nodiscard]] std::size_t size() const { return loop_.size(); }
  [[nodiscard]] std::uint32_t operator[](std::size_t i) const { return vertex(goes_back_ && i != 0 ? size() - i : i); }

 private:
  [[nodiscard]] std::uint32_t vertex(std::size_t i) const { return weld_[loop_[(first_ + i) % size()]]; }

  std::span<const std::uint32_t> loop_, weld_;
  std::size_t first_ = 0;
  bool goes_back_ = false;
};

/// Tells nearly all polygons apart: the first three corners and the number of sides.
struct PolygonKey {
  std::uint32_t first, second, third, sides, polygon;

  [[nodiscard]] bool is_like(const PolygonKey& other) const {
    return first == other.first && second == other.second && third == other.third && sides == other.sides;
  }
  auto operator<=>(const PolygonKey&) const = default;
};

}  // namespace

std::vector<std::uint32_t> polygon_of_sides(SoupView soup) {
  std::vector<std::uint32_t> polygon_of(soup.indices.size());
  for (std::uint32_t p = 0; p < soup.size(); ++p) {
    std::fill_n(polygon_of.begin() + soup.first[p], soup.loop(p).size(), p);
  }
  return polygon_of;
}

std::vector<std::uint32_t> welded(std::span<const glm::dvec3> vertices, const Checkpoint& checkpoint) {
  std::vector<std::uint32_t> order(vertices.size()), result(vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto coordinates = [&](std::uint32_t i) { return std::array{vertices[i].x, vertices[i].y, vertices[i].z}; };
  parallel_sort(order, checkpoint, [&](std::uint32_t a, std::uint32_t b) { return coordinates(a) < coordinates(b); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    checkpoint.at(i);
    const bool is_same = i > 0 && coordinates(order[i]) == coordinates(order[i - 1]);
    result[order[i]] = is_same ? result[order[i - 1]] : order[i];
  }
  return result;
}

std::vector<SidePair> find_adjacency(SoupView soup, std::span<const std::uint32_t> weld, const Checkpoint& checkpoint) {
  std::vector<Side> sides = sides_of(soup, weld, checkpoint);
  parallel_sort(sides, checkpoint);
  std::vector<SidePair> pairs;
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    const Side& side = sides[i];
    while (end < sides.size() && sides[end].low == side.low && sides[end].high == side.high) ++end;
    if (end - i != 2 || side.ascends == sides[i + 1].ascends) continue;
    const glm::dvec3 edge = soup.vertices[side.high] - soup.vertices[side.low];
    pairs.push_back({glm::dot(edge, edge), side.side, sides[i + 1].side});
  }
  parallel_sort(pairs, checkpoint, [](const SidePair& a, const SidePair& b) { return a.length > b.length; });
  return pairs;
}

std::vector<bool> find_repeated(SoupView soup, std::span<const std::uint32_t> weld, const Checkpoint& checkpoint) {
  std::vector<PolygonKey> keys;
  keys.reserve(soup.size());
  for (std::uint32_t p = 0; p < soup.size(); ++p) {
    checkpoint.at(p);
    if (!soup.is_opaque(p)) continue;
    const Corners corners(soup.loop(p), weld);
    keys.push_back({corners[0], corners[1], corners[2], static_cast<std::uint32_t>(corners.size()), p});
  }
  parallel_sort(keys, checkpoint);
  // Compares polygons with equal keys by their remaining corners. The sort is stable, so the first of equal polygons stays
  // first.
  const auto compare = [&](const PolygonKey& a, const PolygonKey& b) {
    const Corners left(soup.loop(a.polygon), weld), right(soup.loop(b.polygon), weld);
    std::size_t i = 3;
    while (i < left.size() && left[i] == right[i]) ++i;
    return i == left.size() ? std::strong_ordering::equal : left[i] <=> right[i];
  };
  std::vector<bool> is_repeated(soup.size());
  for (std::size_t i = 0, end = 0; i < keys.size(); i = end) {
    while (end < keys.size() && keys[end].is_like(keys[i])) ++end;
    const std::span alike = std::span(keys).subspan(i, end - i);
    std::ranges::stable_sort(alike, [&](const PolygonKey& a, const PolygonKey& b) {
      checkpoint();
      return compare(a, b) < 0;
    });
    for (std::size_t k = 1; k < alike.size(); ++k) {
      if (compare(alike[k - 1], alike[k]) == 0) is_repeated[alike[k].polygon] = true;
    }
  }
  return is_repeated;
}

}  // namespace occlude::culler
