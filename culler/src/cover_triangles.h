// SPDX-License-Identifier: MIT
// The triangles of a soup, which of them share edges, and which polygons touch those of a leaf.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "cover_mesh.h"
#include "occlude/culler/array.h"
#include "occlude/culler/checkpoint.h"
#include "occlude/culler/hierarchy.h"
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

/// Polygon p is drawn as the triangles from first(p) to before first(p + 1): the fan of its loop. Several threads may read
/// at once.
class CoverTriangles {
 public:
  static constexpr std::string_view kPrefix = "cover ";  ///< with which the names of its parts begin

  CoverTriangles() = default;
  [[nodiscard]] static CoverTriangles find(SoupView soup, std::span<const HierarchyNode> nodes,
                                           const Checkpoint& checkpoint = {});
  /// For Culler::parts().
  void append_parts(PartWriter& parts) const;
  /// The triangles with these parts. Throws std::invalid_argument unless they are those of the soup, their sides are in
  /// rings as find() makes, and what is around a leaf is within the limits of find(). REQUIRES: the nodes are of the soup.
  [[nodiscard]] static CoverTriangles from_parts(const PartReader& parts, SoupView soup,
                                                 std::span<const HierarchyNode> nodes, const Checkpoint& checkpoint = {});

  /// The number of polygons.
  [[nodiscard]] std::size_t size() const { return first_.empty() ? 0 : first_.size() - 1; }
  [[nodiscard]] std::uint32_t first(std::uint32_t polygon) const { return first_[polygon]; }
  /// Corners with the same coordinates are the same vertex.
  [[nodiscard]] const CoverMesh::Triangle& corners(std::uint32_t triangle) const { return corners_[triangle]; }
  [[nodiscard]] const glm::dvec3& vertex(std::uint32_t vertex) const { return vertices_[vertex]; }
  /// For each side of a triangle, the next one in its ring, in the mesh of all triangles.
  [[nodiscard]] const std::array<RingStep, 3>& next(std::uint32_t triangle) const { return next_[triangle]; }
  /// The polygons that touch those of a leaf, without its own.
  [[nodiscard]] std::span<const std::uint32_t> around(std::uint32_t leaf) const {
    return {around_.data() + first_around_[leaf], around_.data() + first_around_[leaf + std::size_t{1}]};
  }

 private:
  Array<std::uint32_t> first_;
  Array<glm::dvec3> vertices_;  ///< in the order of their polygons: what is near in the tree is near in memory
  Array<CoverMesh::Triangle> corners_;
  Array<std::array<RingStep, 3>> next_;
  Array<std::uint64_t> first_around_;  ///< of the nodes; inner nodes have none
  Array<std::uint32_t> around_;
};

}  // namespace occlude::culler
