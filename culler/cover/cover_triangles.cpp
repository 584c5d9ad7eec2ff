// SPDX-License-Identifier: MIT
#include "cover/cover_triangles.h"

#include <algorithm>
#include <compare>
#include <cstdint>
#include <numeric>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/for_ranges.h"
#include "base/parallel_sort.h"
#include "model/adjacency.h"

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
void join_rings(std::span<const TriangleSide> sides, std::vector<RingStep>& next, const At& at) {
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    at(i);
    while (end < sides.size() && end - i < kMostInRing && sides[end].high == sides[i].high) ++end;
    for (std::size_t k = i; k < end; ++k) {
      const std::uint32_t to = sides[k + 1 < end ? k + 1 : i].side;
      next[sides[k].side] = {to & 0x7FFFFFFFU, end - i <= 2 ? 1U : 0U};
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

  [[nodiscard]] std::vector<RingStep> rings() {
    std::vector<RingStep> next(sides_.size());
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

}  // namespace

CoverTriangles CoverTriangles::find(SoupView soup, const Checkpoint& checkpoint) {
  const std::vector<std::uint32_t> weld = welded(soup.vertices, checkpoint);
  constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  std::vector<std::uint32_t> first, polygons, numbers(soup.vertices.size(), kNone);
  std::vector<glm::dvec3> vertices;
  std::vector<CoverMesh::Triangle> corners;
  first.reserve(soup.first.size());
  vertices.reserve(soup.vertices.size());
  const std::size_t triangles = soup.indices.size() - 2 * soup.size();
  if (triangles > kMostTriangles) throw std::length_error("more than 2^31 sides of triangles");
  corners.reserve(triangles);
  polygons.reserve(triangles);
  const auto number = [&](std::uint32_t v) {
    std::uint32_t& n = numbers[weld[v]];
    if (n == kNone) {
      n = static_cast<std::uint32_t>(vertices.size());
      vertices.push_back(soup.vertices[v]);
    }
    return n;
  };
  for (std::uint32_t p = 0; p < soup.size(); ++p) {
    checkpoint.at(p);
    first.push_back(static_cast<std::uint32_t>(corners.size()));
    if (!soup.is_opaque(p)) continue;
    const auto loop = soup.loop(p);
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      polygons.push_back(p);
      corners.push_back({number(loop[0]), number(loop[i]), number(loop[i + 1])});
    }
  }
  first.push_back(static_cast<std::uint32_t>(corners.size()));
  numbers = std::vector<std::uint32_t>();  // room for what comes
  vertices.shrink_to_fit();
  CoverTriangles result;
  result.next_ = SidesByCorner(corners, vertices.size(), checkpoint).rings();
  result.first_ = std::move(first);
  result.polygons_ = std::move(polygons);
  result.vertices_ = std::move(vertices);
  result.corners_ = std::move(corners);
  return result;
}

}  // namespace occlude::culler
