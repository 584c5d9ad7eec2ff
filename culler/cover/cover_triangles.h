// SPDX-License-Identifier: MIT
// The triangles of a soup, and which of them share edges.
#pragma once

#include <hwy/cache_control.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string_view>

#include "cover/cover_mesh.h"
#include "occlude/culler/executor.h"
#include "occlude/culler/parts.h"
#include "occlude/culler/polygon_soup.h"

namespace occlude::culler {

/// The next side of a ring, and whether the ring has at most two sides. If it has, the step after this one is known.
/// 32 bits, with the side in the lower ones.
struct RingStep {
  std::uint32_t side : 31;
  std::uint32_t is_of_two : 1;
};

class PartReader;
class PartWriter;

/// Polygon p hides as the triangles from first(p) to before first(p + 1): the fan of its loop, or none if it is see-through.
/// Several threads may read at once.
class CoverTriangles {
 public:
  static constexpr std::string_view kPrefix = "cover ";  ///< with which the names of its parts begin

  CoverTriangles() = default;
  [[nodiscard]] static CoverTriangles find(SoupView soup, const Checkpoint& checkpoint = {});
  /// For Culler::parts().
  void append_parts(PartWriter& parts) const;
  /// The triangles with these parts. Throws std::invalid_argument unless they are those of the soup, and their sides are in
  /// rings as find() makes.
  [[nodiscard]] static CoverTriangles from_parts(const PartReader& parts, SoupView soup, const Checkpoint& checkpoint = {});

  /// The number of triangles.
  [[nodiscard]] std::size_t size() const { return corners_.size(); }
  [[nodiscard]] std::uint32_t first(std::uint32_t polygon) const { return first_[polygon]; }
  [[nodiscard]] std::uint32_t polygon(std::uint32_t triangle) const { return polygons_[triangle]; }
  /// Corners with the same coordinates are the same vertex.
  [[nodiscard]] const CoverMesh::Triangle& corners(std::uint32_t triangle) const { return corners_[triangle]; }
  [[nodiscard]] const glm::dvec3& vertex(std::uint32_t vertex) const { return vertices_[vertex]; }
  /// For each side of a triangle, the next one in its ring, in the mesh of all triangles. Sides are numbered as in
  /// CoverMesh.
  [[nodiscard]] RingStep next(std::uint32_t side) const { return next_[side]; }

  /// Hints: that first(polygon) comes; that corners and sides of triangles of the polygons come; that their vertices come.
  void prefetch_first(std::uint32_t polygon) const { hwy::Prefetch(&first_[polygon]); }
  void prefetch_corners(std::uint32_t first_polygon, std::uint32_t end) const {
    const std::uint32_t triangle = first(first_polygon), last = std::max(first(end), triangle + 1) - 1;
    if (triangle >= corners_.size()) return;
    hwy::Prefetch(&corners_[triangle]);
    hwy::Prefetch(&corners_[last]);
    hwy::Prefetch(&next_[3 * triangle]);
    hwy::Prefetch(&next_[3 * last + 2]);
  }
  void prefetch_vertices(std::uint32_t first_polygon, std::uint32_t end) const {
    for (std::uint32_t t = first(first_polygon); t < first(end); ++t) {
      for (const std::uint32_t v : corners_[t]) hwy::Prefetch(&vertices_[v]);
    }
  }

 private:
  Array<std::uint32_t> first_, polygons_;
  Array<glm::dvec3> vertices_;  ///< in the order of their polygons: what is near in the tree is near in memory
  Array<CoverMesh::Triangle> corners_;
  Array<RingStep> next_;
};

}  // namespace occlude::culler
