// SPDX-License-Identifier: MIT
// The parts of the triangles of a model, and the checks of parts that are said to be those.
#include <algorithm>
#include <string_view>

#include "base/part_checks.h"
#include "cover/cover_triangles.h"
#include "model/part_list.h"

namespace occlude::culler {
namespace {

constexpr std::string_view kCoverFirst = "cover first", kCoverVertices = "cover vertices", kCoverCorners = "cover corners",
                           kCoverPolygons = "cover polygons", kCoverNext = "cover next";

/// Whether polygon p hides as it must: a see-through one has no triangles, and those of others are its fan: their corners
/// are the vertices of its loop, and those of a triangle with the same coordinates are the same. Each vertex is compared
/// once.
bool is_fan(std::size_t p, SoupView soup, const Array<std::uint32_t>& first, const Array<glm::dvec3>& vertices,
            const Array<CoverMesh::Triangle>& corners) {
  if (!soup.is_opaque(p)) return first[p + 1] == first[p];
  if (first[p + 1] - first[p] != soup.triangles(p)) return false;
  const auto loop = soup.loop(p);
  const auto of_soup = [&](std::size_t i) -> const glm::dvec3& { return soup.vertices[loop[i]]; };
  const auto is_vertex = [&](std::uint32_t corner, std::size_t i) {
    return corner < vertices.size() && vertices[corner] == of_soup(i);
  };
  const auto is_side = [&](std::uint32_t a, std::size_t i, std::uint32_t b, std::size_t j) {
    return a == b || of_soup(i) != of_soup(j);
  };
  std::uint32_t middle = corners[first[p]][0], last = corners[first[p]][1];
  if (!is_vertex(middle, 0) || !is_vertex(last, 1) || !is_side(middle, 0, last, 1)) return false;
  for (std::size_t i = 2; i < loop.size(); ++i) {
    const CoverMesh::Triangle& triangle = corners[first[p] + i - 2];
    if (triangle[0] != middle || triangle[1] != last) return false;
    last = triangle[2];
    if (!is_vertex(last, i) || !is_side(triangle[1], i - 1, last, i) || !is_side(last, i, middle, 0)) return false;
  }
  return true;
}

/// The rings of the sides.
class Rings {
 public:
  Rings(const Array<CoverMesh::Triangle>& corners, const Array<RingStep>& next) : corners_(corners), next_(next) {}

  /// Whether the side is in a ring of at most kMostInRing sides along one edge, and its step says whether these are two at
  /// most.
  [[nodiscard]] bool has(std::uint32_t side) const {
    const RingStep first = step(side);
    std::size_t length = 1;
    for (std::uint32_t at = first.side; at != side; at = step(at).side, ++length) {
      if (at >= 3 * corners_.size() || length == kMostInRing || !are_along(at, side)) return false;
    }
    return (length <= 2) == (first.is_of_two != 0);
  }

 private:
  [[nodiscard]] RingStep step(std::uint32_t side) const { return next_[side]; }
  [[nodiscard]] std::uint32_t from(std::uint32_t side) const { return corners_[side / 3][side % 3]; }
  [[nodiscard]] std::uint32_t to(std::uint32_t side) const { return corners_[side / 3][(side + 1) % 3]; }
  [[nodiscard]] bool are_along(std::uint32_t a, std::uint32_t b) const {
    return (from(a) == from(b) && to(a) == to(b)) || (from(a) == to(b) && to(a) == from(b));
  }

  const Array<CoverMesh::Triangle>& corners_;
  const Array<RingStep>& next_;
};

}  // namespace

void CoverTriangles::append_parts(PartWriter& parts) const {
  parts.put(kCoverFirst, first_);
  parts.put(kCoverPolygons, polygons_);
  parts.put(kCoverVertices, vertices_);
  parts.put(kCoverCorners, corners_);
  parts.put(kCoverNext, next_);
}

CoverTriangles CoverTriangles::from_parts(const PartReader& parts, SoupView soup, const Checkpoint& checkpoint) {
  CoverTriangles result;
  result.first_ = parts.get<std::uint32_t>(kCoverFirst);
  result.polygons_ = parts.get<std::uint32_t>(kCoverPolygons);
  result.vertices_ = parts.get<glm::dvec3>(kCoverVertices);
  result.corners_ = parts.get<CoverMesh::Triangle>(kCoverCorners);
  result.next_ = parts.get<RingStep>(kCoverNext);

  const std::size_t triangles = result.corners_.size();
  const auto is_polygon = [&](std::size_t p) { return is_fan(p, soup, result.first_, result.vertices_, result.corners_); };
  if (result.first_.size() != soup.first.size() || !are_starts(result.first_, triangles, checkpoint) ||
      !are_all(soup.size(), is_polygon, checkpoint)) {
    refuse_part(kCoverCorners, "the triangles are not those of the polygons");
  }
  const auto is_of_its_polygon = [&](std::size_t p) {
    const auto own = std::span(result.polygons_.begin() + result.first_[p], result.polygons_.begin() + result.first_[p + 1]);
    return std::ranges::all_of(own, [&](std::uint32_t polygon) { return polygon == p; });
  };
  if (result.polygons_.size() != triangles || !are_all(soup.size(), is_of_its_polygon, checkpoint)) {
    refuse_part(kCoverPolygons, "the triangles are of other polygons");
  }
  const Rings rings(result.corners_, result.next_);
  const auto is_in_ring = [&](std::size_t side) { return rings.has(static_cast<std::uint32_t>(side)); };
  if (result.next_.size() != 3 * triangles || !are_all(3 * triangles, is_in_ring, checkpoint)) {
    refuse_part(kCoverNext, "the sides are not in rings");
  }
  return result;
}

}  // namespace occlude::culler
