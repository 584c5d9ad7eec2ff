// SPDX-License-Identifier: MIT
#include "frusta/convex_regions.h"

#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "base/disjoint_sets.h"
#include "model/adjacency.h"
#include "model/bounds.h"

namespace occlude::culler {
namespace {

/// The least cosine between the mean normals of what is joined: about a milliradian at every join. The near plane of the
/// region's shadow lies beyond the whole region, so a bend moves it back.
constexpr double kFlat = 1 - 0x1p-21;
/// The least sine of the turn at the ends of a shared edge, unless the path goes straight on there. A corner that rounding
/// may turn the other way would make the region useless from half of all viewpoints.
constexpr double kTurn = 0x1p-20;
/// The loops of the polygons, with linked sides.
class Sides {
 public:
  explicit Sides(SoupView soup) : soup_(soup), next_(soup.indices.size()), previous_(soup.indices.size()) {
    for (std::size_t p = 0; p < soup.size(); ++p) {
      const std::uint32_t first = soup.first[p], end = soup.first[p + 1];
      for (std::uint32_t s = first; s < end; ++s) link(s, s + 1 < end ? s + 1 : first);
    }
  }

  [[nodiscard]] const glm::dvec3& from(std::uint32_t side) const { return soup_.vertices[soup_.indices[side]]; }
  [[nodiscard]] const glm::dvec3& to(std::uint32_t side) const { return from(next_[side]); }
  [[nodiscard]] std::uint32_t next(std::uint32_t side) const { return next_[side]; }
  [[nodiscard]] std::uint32_t previous(std::uint32_t side) const { return previous_[side]; }

  /// Joins the loops of the two sides into one, which no longer has these two sides.
  void join(std::uint32_t side, std::uint32_t twin) {
    link(previous_[side], next_[twin]);
    link(previous_[twin], next_[side]);
  }

 private:
  void link(std::uint32_t a, std::uint32_t b) {
    next_[a] = b;
    previous_[b] = a;
  }

  SoupView soup_;
  std::vector<std::uint32_t> next_, previous_;
};

/// Whether the path along u and then v turns the same way as the area, by at least this sine, or goes straight on.
bool turns(const glm::dvec3& u, const glm::dvec3& v, const glm::dvec3& area, double least) {
  const double turn = glm::dot(glm::cross(u, v), area);
  if (turn == 0) return glm::dot(u, v) >= 0;
  return turn >= least * glm::length(u) * glm::length(v) * glm::length(area);
}

/// Whether the loop turns the same way as its area everywhere, and so does its fan. A star that runs round twice passes only
/// the first check.
bool turns_with(SoupView soup, std::span<const std::uint32_t> loop, const glm::dvec3& area) {
  const std::size_t n = loop.size();
  const glm::dvec3& base = soup.vertices[loop[0]];
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec3 &a = soup.vertices[loop[i]], &b = soup.vertices[loop[(i + 1) % n]];
    if (!turns(b - a, soup.vertices[loop[(i + 2) % n]] - b, area, 0)) return false;
    if (glm::dot(glm::cross(a - base, b - base), area) < 0) return false;
  }
  return true;
}

/// The polygons joined so far. Each set is identified by one of its polygons.
class Merging {
 public:
  Merging(SoupView soup, std::span<const SidePair> adjacency, const Checkpoint& checkpoint)
      : soup_(soup),
        sides_(soup),
        joined_(soup.size()),
        sets_(soup.size()),
        is_convex_(soup.size()),
        polygon_of_(polygon_of_sides(soup)) {
    for (std::uint32_t p = 0; p < soup.size(); ++p) {
      checkpoint.at(p);
      const auto loop = soup.loop(p);
      const glm::dvec3 area = doubled_area(soup, loop);
      is_convex_[p] = turns_with(soup, loop, area);
      sets_[p] = {static_cast<std::uint32_t>(loop.size()), soup.first[p], is_convex_[p] ? area : glm::dvec3{0, 0, 0}};
    }
    for (std::size_t i = 0; i < adjacency.size(); ++i) {
      checkpoint.at(i);
      try_to_join(adjacency[i].side, adjacency[i].twin);
    }
  }

  /// Calls visit(polygons) for every set.
  template <class Visit>
  void for_each_set(Visit&& visit) {
    joined_.for_each_set(visit);
  }
  /// Whether the polygon is convex, as far as doubles can tell.
  [[nodiscard]] bool is_convex(std::uint32_t polygon) const { return is_convex_[polygon]; }
  /// Appends the corners of the set that the polygon is in. A polygon alone keeps the order given.
  void append_loop(std::uint32_t polygon, std::vector<std::uint32_t>& vertices) {
    const std::uint32_t first = sets_[joined_.find(polygon)].side;
    std::uint32_t side = first;
    do {
      vertices.push_back(soup_.indices[side]);
      side = sides_.next(side);
    } while (side != first);
  }

 private:
  struct Set {
    std::uint32_t sides, side;
    glm::dvec3 area;  ///< twice the area, along the normal; zero for a polygon that must stay alone
  };

  /// Whether the path along `side` and then `other`, which begins where `side` ends, turns the same way as the area.
  [[nodiscard]] bool turns(std::uint32_t side, std::uint32_t other, const glm::dvec3& area) const {
    return culler::turns(sides_.to(side) - sides_.from(side), sides_.to(other) - sides_.from(other), area, kTurn);
  }

  void try_to_join(std::uint32_t side, std::uint32_t twin) {
    const std::uint32_t a = joined_.find(polygon_of_[side]), b = joined_.find(polygon_of_[twin]);
    if (a == b || sets_[a].sides + sets_[b].sides > ConvexRegions::kMostJoined + 2) return;
    const glm::dvec3 &area = sets_[a].area, &other = sets_[b].area, sum = area + other;
    if (!(glm::dot(area, other) > kFlat * glm::length(area) * glm::length(other))) return;
    if (!turns(sides_.previous(side), sides_.next(twin), sum)) return;
    if (!turns(sides_.previous(twin), sides_.next(side), sum)) return;
    sides_.join(side, twin);
    joined_.join(a, b);
    sets_[a] = {sets_[a].sides + sets_[b].sides - 2, sides_.next(twin), sum};
  }

  SoupView soup_;
  Sides sides_;
  DisjointSets joined_;
  std::vector<Set> sets_;
  std::vector<bool> is_convex_;
  std::vector<std::uint32_t> polygon_of_;  ///< of each side
};

/// Divides the fan of a polygon into runs of triangles (v0, vi, vi+1), ..., (v0, vj-1, vj). The loop (v0, vi, ..., vj) of a
/// run is convex, unless it is a single triangle, and has at most `most` sides.
std::vector<FanRun> convex_runs(SoupView soup, std::span<const std::uint32_t> loop, std::uint32_t most) {
  const auto count = static_cast<std::uint32_t>(loop.size() - 2);
  std::vector<FanRun> runs;
  std::vector<std::uint32_t> piece;
  for (std::uint32_t first = 0, length = 0; first < count; first += length) {
    piece = {loop[0], loop[first + 1], loop[first + 2]};
    for (length = 1; first + length < count && length + 2 < most; ++length) {
      piece.push_back(loop[first + length + 2]);
      const glm::dvec3 area = doubled_area(soup, piece);
      if (area == glm::dvec3{0, 0, 0} || !turns_with(soup, piece, area)) break;
    }
    runs.push_back({first, length});
  }
  return runs;
}

}  // namespace

std::vector<std::uint32_t> piece_of(std::span<const std::uint32_t> loop, const FanRun& run) {
  std::vector<std::uint32_t> piece{loop[0]};
  const auto rest = loop.subspan(run.first + 1, run.count + 1);
  piece.insert(piece.end(), rest.begin(), rest.end());
  return piece;
}

ConvexRegions ConvexRegions::find(SoupView soup, std::span<const SidePair> adjacency, const Checkpoint& checkpoint) {
  const auto count = static_cast<std::uint32_t>(soup.size());
  std::vector<std::uint32_t> vertices, first_vertex{0};
  vertices.reserve(soup.indices.size());
  first_vertex.reserve(soup.first.size());
  for (std::uint32_t p = 0; p < count; ++p) {
    const auto corners = corners_of_region(soup, p);
    vertices.insert(vertices.end(), corners.begin(), corners.end());
    first_vertex.push_back(static_cast<std::uint32_t>(vertices.size()));
  }
  std::vector<std::uint32_t> polygons(count), first_polygon(count + std::size_t{1});
  std::iota(polygons.begin(), polygons.end(), 0U);
  std::iota(first_polygon.begin(), first_polygon.end(), 0U);
  std::vector<std::uint32_t> whole = polygons;
  std::vector<FanRun> runs;
  const auto regions = [&] { return first_vertex.size() - 1; };
  const auto end_region = [&] {
    first_vertex.push_back(static_cast<std::uint32_t>(vertices.size()));
    first_polygon.push_back(static_cast<std::uint32_t>(polygons.size()));
  };

  Merging merging(soup, adjacency, checkpoint);
  merging.for_each_set([&](std::span<const std::uint32_t> set) {
    if (set.size() == 1) return;
    checkpoint();
    for (const std::uint32_t p : set) {
      whole[p] = static_cast<std::uint32_t>(regions());
      polygons.push_back(p);
    }
    merging.append_loop(set.front(), vertices);
    end_region();
  });

  ConvexRegions result;
  result.first_piece_ = regions();
  for (std::uint32_t p = 0; p < count; ++p) {
    checkpoint.at(p);
    const std::size_t sides = corners_of_region(soup, p).size();
    if (sides <= 3 || (merging.is_convex(p) && sides <= kMostSides)) continue;
    for (const FanRun& run : convex_runs(soup, soup.loop(p), merging.is_convex(p) ? kMostSides : kMostJoined)) {
      const auto piece = piece_of(soup.loop(p), run);
      vertices.insert(vertices.end(), piece.begin(), piece.end());
      polygons.push_back(p);
      runs.push_back(run);
      end_region();
    }
  }
  result.vertices_ = std::move(vertices);
  result.first_vertex_ = std::move(first_vertex);
  result.polygons_ = std::move(polygons);
  result.first_polygon_ = std::move(first_polygon);
  result.whole_ = std::move(whole);
  result.runs_ = std::move(runs);
  return result;
}

}  // namespace occlude::culler
