// SPDX-License-Identifier: MIT
#include "cover_triangles.h"

#include <algorithm>
#include <compare>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "adjacency.h"
#include "cover_limits.h"
#include "for_ranges.h"

namespace occlude::culler {
namespace {

/// A side of a triangle, by the higher corner of the edge that it runs along.
struct TriangleSide {
  std::uint32_t high, side;

  auto operator<=>(const TriangleSide&) const = default;
};

/// Calls visit(low, {high, side}) for each side of each triangle, in order.
template <class Visit>
void for_each_side(std::span<const CoverMesh::Triangle> triangles, const Checkpoint& checkpoint, const Visit& visit) {
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    checkpoint.at(t);
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(triangles[t][i], triangles[t][(i + 1) % 3]);
      visit(low, TriangleSide{high, 3 * t + i});
    }
  }
}

/// Makes rings of the sides whose edges have one lower corner.
void join_rings(std::span<TriangleSide> sides, std::vector<std::array<RingStep, 3>>& next) {
  std::ranges::sort(sides);
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    while (end < sides.size() && end - i < kMostInRing && sides[end].high == sides[i].high) ++end;
    for (std::size_t k = i; k < end; ++k) {
      const std::uint32_t from = sides[k].side, to = sides[k + 1 < end ? k + 1 : i].side;
      next[from / 3][from % 3] = {to & 0x7FFFFFFFU, end - i <= 2 ? 1U : 0U};
    }
  }
}

/// Sides are put in order by the lower corners of their edges, by counting, and then among the few that share one.
std::vector<std::array<RingStep, 3>> find_next(std::span<const CoverMesh::Triangle> triangles, std::size_t vertices,
                                               const Checkpoint& checkpoint) {
  // Where the sides of each corner begin; once they are in place, where they end.
  std::vector<std::uint32_t> ends(vertices + 1);
  for_each_side(triangles, checkpoint, [&](std::uint32_t low, TriangleSide) { ++ends[low + std::size_t{1}]; });
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<TriangleSide> sides(3 * triangles.size());
  for_each_side(triangles, checkpoint, [&](std::uint32_t low, TriangleSide side) { sides[ends[low]++] = side; });
  std::vector<std::array<RingStep, 3>> next(triangles.size());
  const auto join_rings_at = [&](std::size_t v) {
    const std::size_t begin = v == 0 ? 0 : ends[v - 1];
    join_rings(std::span(sides).subspan(begin, ends[v] - begin), next);
  };
  for_ranges(
      vertices,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) join_rings_at(v);
      },
      checkpoint);
  return next;
}

/// For each vertex, the polygons that have it.
class Incidence {
 public:
  Incidence(SoupView soup, std::span<const std::uint32_t> weld)
      : first_(soup.vertices.size() + 1), polygons_(soup.indices.size()) {
    for (const std::uint32_t v : soup.indices) ++first_[weld[v] + std::size_t{1}];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t p = 0; p < soup.size(); ++p) {
      for (const std::uint32_t v : soup.loop(p)) polygons_[next[weld[v]]++] = p;
    }
  }
  [[nodiscard]] std::span<const std::uint32_t> polygons_at(std::uint32_t vertex) const {
    return std::span(polygons_).subspan(first_[vertex], first_[vertex + std::size_t{1}] - first_[vertex]);
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> polygons_;
};

/// Appends the polygons around leaves.
class Around {
 public:
  Around(SoupView soup, std::span<const std::uint32_t> weld)
      : soup_(soup), weld_(weld), incidence_(soup, weld), leaf_of_(soup.size(), kNone) {}

  void append(const HierarchyNode& leaf, std::vector<std::uint32_t>& around) {
    const std::uint32_t end = leaf.first + leaf.count;
    for (std::uint32_t p = leaf.first; p < end; ++p) leaf_of_[p] = leaf.first;
    std::size_t left = kMostAround * (soup_.first[end] - soup_.first[leaf.first] - 2 * std::size_t{leaf.count});
    for (std::uint32_t p = leaf.first; p < end; ++p) {
      for (const std::uint32_t v : soup_.loop(p)) {
        const auto at_corner = incidence_.polygons_at(weld_[v]);
        if (at_corner.size() > kMostAtCorner) continue;
        for (const std::uint32_t other : at_corner) {
          if (leaf_of_[other] == leaf.first || soup_.loop(other).size() > kMostSidesAround) continue;
          if (soup_.triangles(other) > left) return;
          left -= soup_.triangles(other);
          leaf_of_[other] = leaf.first;
          around.push_back(other);
        }
      }
    }
  }

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

  SoupView soup_;
  std::span<const std::uint32_t> weld_;
  Incidence incidence_;
  std::vector<std::uint32_t> leaf_of_;  ///< for each polygon, the first polygon of the last leaf that it is in or around
};

}  // namespace

CoverTriangles CoverTriangles::find(SoupView soup, std::span<const HierarchyNode> nodes, const Checkpoint& checkpoint) {
  const std::vector<std::uint32_t> weld = welded(soup.vertices, checkpoint);
  constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  std::vector<std::uint32_t> first, numbers(soup.vertices.size(), kNone);
  std::vector<glm::dvec3> vertices;
  std::vector<CoverMesh::Triangle> corners;
  first.reserve(soup.first.size());
  vertices.reserve(soup.vertices.size());
  corners.reserve(soup.indices.size() - 2 * soup.size());
  const auto number = [&](std::uint32_t v) {
    std::uint32_t& n = numbers[weld[v]];
    if (n == kNone) {
      n = static_cast<std::uint32_t>(vertices.size());
      vertices.push_back(soup.vertices[v]);
    }
    return n;
  };
  for (std::uint32_t p = 0; p < soup.size(); ++p) {
    first.push_back(static_cast<std::uint32_t>(corners.size()));
    const auto loop = soup.loop(p);
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      corners.push_back({number(loop[0]), number(loop[i]), number(loop[i + 1])});
    }
  }
  first.push_back(static_cast<std::uint32_t>(corners.size()));
  numbers = {};  // memory for what comes
  CoverTriangles result;
  result.next_ = find_next(corners, vertices.size(), checkpoint);
  result.first_ = std::move(first);
  result.vertices_ = std::move(vertices);
  result.corners_ = std::move(corners);
  std::vector<std::uint64_t> first_around;
  first_around.reserve(nodes.size() + 1);
  std::vector<std::uint32_t> all_around;
  Around around(soup, weld);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    checkpoint.at(n);
    first_around.push_back(all_around.size());
    if (nodes[n].is_leaf()) around.append(nodes[n], all_around);
  }
  first_around.push_back(all_around.size());
  result.first_around_ = std::move(first_around);
  result.around_ = std::move(all_around);
  return result;
}

}  // namespace occlude::culler
