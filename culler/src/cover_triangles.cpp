// SPDX-License-Identifier: MIT
#include "cover_triangles.h"

#include <algorithm>
#include <compare>
#include <cstdint>
#include <numeric>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "adjacency.h"
#include "cover_limits.h"
#include "for_ranges.h"
#include "parallel_sort.h"

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

/// With more, a RingStep could not number their sides.
constexpr std::size_t kMostTriangles = (std::size_t{1} << 31U) / 3;

/// Makes rings of sides that are in order, and have one lower corner. Calls at(i) for the first of each ring.
template <class At>
void join_rings(std::span<const TriangleSide> sides, std::vector<std::array<RingStep, 3>>& next, const At& at) {
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    at(i);
    while (end < sides.size() && end - i < kMostInRing && sides[end].high == sides[i].high) ++end;
    for (std::size_t k = i; k < end; ++k) {
      const std::uint32_t from = sides[k].side, to = sides[k + 1 < end ? k + 1 : i].side;
      next[from / 3][from % 3] = {to & 0x7FFFFFFFU, end - i <= 2 ? 1U : 0U};
    }
  }
}

/// Sides are put in order by the lower corners of their edges, by counting, and then among those that share one.
class SidesByCorner {
 public:
  SidesByCorner(std::span<const CoverMesh::Triangle> triangles, std::size_t corners, const Checkpoint& checkpoint)
      : ends_(corners + 1), sides_(3 * triangles.size()), checkpoint_(checkpoint) {
    for_each_side(triangles, checkpoint, [&](std::uint32_t low, TriangleSide) { ++ends_[low + std::size_t{1}]; });
    std::partial_sum(ends_.begin(), ends_.end(), ends_.begin());
    for_each_side(triangles, checkpoint, [&](std::uint32_t low, TriangleSide side) { sides_[ends_[low]++] = side; });
    ends_.pop_back();
  }

  [[nodiscard]] std::vector<std::array<RingStep, 3>> rings() {
    std::vector<std::array<RingStep, 3>> next(sides_.size() / 3);
    const auto join_few = [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v) {
        if (is_hub(v)) continue;
        std::ranges::sort(at(v));
        join_rings(at(v), next, [](std::size_t) {});
      }
    };
    for_ranges(ends_.size(), join_few, checkpoint_);
    for (std::size_t v = 0; v < ends_.size(); ++v) {
      if (!is_hub(v)) continue;
      std::vector<TriangleSide> sides(at(v).begin(), at(v).end());
      parallel_sort(sides, checkpoint_);
      join_rings(sides, next, [&](std::size_t i) { checkpoint_.at(i); });
    }
    return next;
  }

 private:
  /// Up to so many are sorted in a millisecond.
  static constexpr std::size_t kFewSides = std::size_t{1} << 14U;

  [[nodiscard]] std::span<TriangleSide> at(std::size_t v) {
    const std::size_t begin = v == 0 ? 0 : ends_[v - 1];
    return std::span(sides_).subspan(begin, ends_[v] - begin);
  }
  [[nodiscard]] bool is_hub(std::size_t v) { return at(v).size() > kFewSides; }

  std::vector<std::uint32_t> ends_;  ///< of the sides at each corner; their beginnings, until they are in place
  std::vector<TriangleSide> sides_;
  const Checkpoint& checkpoint_;
};

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
  const std::size_t triangles = soup.indices.size() - 2 * soup.size();
  if (triangles > kMostTriangles) throw std::length_error("more than 2^31 sides of triangles");
  corners.reserve(triangles);
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
  numbers = std::vector<std::uint32_t>();  // room for what comes
  vertices.shrink_to_fit();
  CoverTriangles result;
  result.next_ = SidesByCorner(corners, vertices.size(), checkpoint).rings();
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
