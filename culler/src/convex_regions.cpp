// SPDX-License-Identifier: MIT
#include "occlude/culler/convex_regions.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "bounds.h"

namespace occlude::culler {
namespace {

/// The least cosine between the mean normals of what is joined, about a milliradian at every join: the near plane of the
/// region's shadow lies beyond all of it, and a bend moves that back.
constexpr double kFlat = 1 - 0x1p-21;
/// The least sine of the turn at the ends of an edge across which polygons are joined, unless the way goes straight on. A
/// corner that rounding may turn the other way would make the region useless from half of all viewpoints.
constexpr double kTurn = 0x1p-20;
/// Planes of a shadow cost time at every test; few walls have more sides.
constexpr std::uint32_t kMostSides = 32;

/// Sides of all polygons: side s runs from the vertex indices[s] to the next of the same loop.
class Sides {
 public:
  explicit Sides(const PolygonSoup& soup)
      : soup_(soup), welded_(soup.vertices.size()), next_(soup.indices.size()), previous_(soup.indices.size()) {
    weld();
    for (std::size_t p = 0; p < soup.size(); ++p) link(soup.first[p], soup.first[p + 1]);
  }

  [[nodiscard]] const glm::dvec3& from(std::uint32_t side) const { return soup_.vertices[soup_.indices[side]]; }
  [[nodiscard]] const glm::dvec3& to(std::uint32_t side) const { return from(next_[side]); }
  [[nodiscard]] std::uint32_t next(std::uint32_t side) const { return next_[side]; }
  [[nodiscard]] std::uint32_t previous(std::uint32_t side) const { return previous_[side]; }

  /// Two sides along one edge, in opposite directions and with no third there.
  struct Pair {
    double length;  ///< squared
    std::uint32_t side, twin;
  };

  /// Longest first: the diagonal of a rectangle goes before its sides.
  [[nodiscard]] std::vector<Pair> pairs() const {
    struct Keyed {
      std::uint32_t low, high, side;
      auto operator<=>(const Keyed&) const = default;
    };
    std::vector<Keyed> keyed(next_.size());
    for (std::uint32_t s = 0; s < keyed.size(); ++s) {
      const std::uint32_t a = welded_from(s), b = welded_from(next_[s]);
      keyed[s] = {std::min(a, b), std::max(a, b), s};
    }
    std::ranges::sort(keyed);
    std::vector<Pair> result;
    for (std::size_t i = 0, end = 0; i < keyed.size(); i = end) {
      while (end < keyed.size() && keyed[end].low == keyed[i].low && keyed[end].high == keyed[i].high) ++end;
      if (end - i != 2 || keyed[i].low == keyed[i].high) continue;
      const std::uint32_t side = keyed[i].side, twin = keyed[i + 1].side;
      if (welded_from(side) == welded_from(twin)) continue;
      const glm::dvec3 edge = to(side) - from(side);
      result.push_back({glm::dot(edge, edge), side, twin});
    }
    std::ranges::stable_sort(result, std::ranges::greater(), &Pair::length);
    return result;
  }

  /// Makes one loop of those that the two sides are of, which are lost.
  void join(std::uint32_t side, std::uint32_t twin) {
    link_two(previous_[side], next_[twin]);
    link_two(previous_[twin], next_[side]);
  }

 private:
  /// The first vertex with the same coordinates stands for all.
  void weld() {
    std::vector<std::uint32_t> order(soup_.vertices.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto coordinates = [&](std::uint32_t i) {
      const glm::dvec3& v = soup_.vertices[i];
      return std::array{v.x, v.y, v.z};
    };
    std::ranges::stable_sort(order, {}, coordinates);
    for (std::size_t i = 0; i < order.size(); ++i) {
      const bool is_same = i > 0 && coordinates(order[i]) == coordinates(order[i - 1]);
      welded_[order[i]] = is_same ? welded_[order[i - 1]] : order[i];
    }
  }

  [[nodiscard]] std::uint32_t welded_from(std::uint32_t side) const { return welded_[soup_.indices[side]]; }

  void link_two(std::uint32_t a, std::uint32_t b) {
    next_[a] = b;
    previous_[b] = a;
  }

  void link(std::uint32_t first, std::uint32_t end) {
    for (std::uint32_t s = first; s < end; ++s) link_two(s, s + 1 < end ? s + 1 : first);
  }

  const PolygonSoup& soup_;
  std::vector<std::uint32_t> welded_, next_, previous_;
};

/// Polygons joined so far, each set known by one of them.
class Merging {
 public:
  explicit Merging(const PolygonSoup& soup)
      : soup_(soup), sides_(soup), sets_(soup.size()), polygon_of_(soup.indices.size()) {
    for (std::uint32_t p = 0; p < soup.size(); ++p) {
      sets_[p] = {p, static_cast<std::uint32_t>(soup.loop(p).size()), soup.first[p], area_of(p)};
      std::fill_n(polygon_of_.begin() + soup.first[p], soup.loop(p).size(), p);
    }
    for (const auto& [length, side, twin] : sides_.pairs()) try_to_join(side, twin);
  }

  [[nodiscard]] std::uint32_t set_of(std::uint32_t polygon) {
    std::uint32_t root = polygon;
    while (sets_[root].parent != root) root = sets_[root].parent;
    while (sets_[polygon].parent != root) polygon = std::exchange(sets_[polygon].parent, root);
    return root;
  }
  /// The corners of the set; of a polygon alone in the order given.
  void append_loop(std::uint32_t set, std::vector<std::uint32_t>& vertices) const {
    std::uint32_t side = sets_[set].side;
    do {
      vertices.push_back(soup_.indices[side]);
      side = sides_.next(side);
    } while (side != sets_[set].side);
  }

 private:
  struct Set {
    std::uint32_t parent, sides, side;
    glm::dvec3 area;  ///< twice it, along the normal; zero for what must stay alone
  };

  /// Zero unless the polygon is convex.
  [[nodiscard]] glm::dvec3 area_of(std::uint32_t p) const {
    const std::uint32_t first = soup_.first[p], end = soup_.first[p + 1];
    const glm::dvec3 area = doubled_area(soup_, soup_.loop(p));
    for (std::uint32_t s = first; s < end; ++s) {
      if (!turns(sides_.previous(s), s, area, 0)) return {0, 0, 0};
    }
    return area;
  }

  /// Whether the way from a side to another, which begins where it ends, turns with the area by more than this sine, or goes
  /// straight on.
  [[nodiscard]] bool turns(std::uint32_t side, std::uint32_t other, const glm::dvec3& area, double least) const {
    const glm::dvec3 u = sides_.to(side) - sides_.from(side), v = sides_.to(other) - sides_.from(other);
    const double turn = glm::dot(glm::cross(u, v), area);
    if (turn == 0) return glm::dot(u, v) >= 0;
    return turn >= least * glm::length(u) * glm::length(v) * glm::length(area);
  }

  void try_to_join(std::uint32_t side, std::uint32_t twin) {
    const std::uint32_t a = set_of(polygon_of_[side]), b = set_of(polygon_of_[twin]);
    if (a == b || sets_[a].sides + sets_[b].sides > kMostSides + 2) return;
    const glm::dvec3 &area = sets_[a].area, &other = sets_[b].area, sum = area + other;
    if (!(glm::dot(area, other) > kFlat * glm::length(area) * glm::length(other))) return;
    if (!turns(sides_.previous(side), sides_.next(twin), sum, kTurn)) return;
    if (!turns(sides_.previous(twin), sides_.next(side), sum, kTurn)) return;
    sides_.join(side, twin);
    sets_[b].parent = a;
    sets_[a] = {a, sets_[a].sides + sets_[b].sides - 2, sides_.next(twin), sum};
  }

  const PolygonSoup& soup_;
  Sides sides_;
  std::vector<Set> sets_;
  std::vector<std::uint32_t> polygon_of_;  ///< of each side
};

}  // namespace

ConvexRegions ConvexRegions::find(const PolygonSoup& soup) {
  const auto count = static_cast<std::uint32_t>(soup.size());
  ConvexRegions result;
  result.vertices_ = soup.indices;
  result.first_vertex_ = soup.first;
  result.polygons_.resize(count);
  result.first_polygon_.resize(count + 1);
  std::iota(result.polygons_.begin(), result.polygons_.end(), 0U);
  std::iota(result.first_polygon_.begin(), result.first_polygon_.end(), 0U);
  result.whole_ = result.polygons_;

  Merging merging(soup);
  std::vector<std::uint32_t> by_set = result.polygons_;
  std::ranges::stable_sort(by_set, {}, [&](std::uint32_t p) { return merging.set_of(p); });
  for (std::size_t first = 0, end = 0; first < count; first = end) {
    const std::uint32_t set = merging.set_of(by_set[first]);
    while (end < count && merging.set_of(by_set[end]) == set) ++end;
    if (end - first == 1) continue;
    for (std::size_t i = first; i < end; ++i) {
      result.whole_[by_set[i]] = static_cast<std::uint32_t>(result.size());
      result.polygons_.push_back(by_set[i]);
    }
    merging.append_loop(set, result.vertices_);
    result.first_vertex_.push_back(static_cast<std::uint32_t>(result.vertices_.size()));
    result.first_polygon_.push_back(static_cast<std::uint32_t>(result.polygons_.size()));
  }
  return result;
}

}  // namespace occlude::culler
