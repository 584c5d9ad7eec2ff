// SPDX-License-Identifier: MIT
// The triangles of a soup, which of them share edges, and which polygons touch those of a leaf.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "cover_mesh.h"
#include "occlude/culler/checkpoint.h"
#include "occlude/culler/hierarchy.h"

namespace occlude::culler {

/// The next side of a ring, and whether the ring has but two, or one: then what follows that is known.
struct RingStep {
  std::uint32_t side : 31;
  std::uint32_t is_of_two : 1;
};

/// Polygon p is the triangles from first(p) to before first(p + 1), the fan of its loop. May be asked on several threads at
/// once.
class CoverTriangles {
 public:
  CoverTriangles() = default;
  [[nodiscard]] static CoverTriangles find(const PolygonSoup& soup, std::span<const HierarchyNode> nodes,
                                           const Checkpoint& checkpoint = {});

  /// Polygons.
  [[nodiscard]] std::size_t size() const { return first_.empty() ? 0 : first_.size() - 1; }
  [[nodiscard]] std::uint32_t first(std::uint32_t polygon) const { return first_[polygon]; }
  /// The same vertex wherever corners have the same coordinates.
  [[nodiscard]] const CoverMesh::Triangle& corners(std::uint32_t triangle) const { return corners_[triangle]; }
  [[nodiscard]] const glm::dvec3& vertex(std::uint32_t vertex) const { return vertices_[vertex]; }
  /// Of each side of a triangle, as in a mesh of all triangles, where its ring goes on.
  [[nodiscard]] const std::array<RingStep, 3>& next(std::uint32_t triangle) const { return next_[triangle]; }
  /// Polygons that touch those of a leaf, and are not its own.
  [[nodiscard]] std::span<const std::uint32_t> around(std::uint32_t leaf) const {
    return std::span(around_).subspan(first_around_[leaf], first_around_[leaf + std::size_t{1}] - first_around_[leaf]);
  }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<glm::dvec3> vertices_;  ///< in the order of their polygons, so that what is near in the tree is near in memory
  std::vector<CoverMesh::Triangle> corners_;
  std::vector<std::array<RingStep, 3>> next_;
  std::vector<std::size_t> first_around_;  ///< of the nodes; none of inner ones
  std::vector<std::uint32_t> around_;
};

}  // namespace occlude::culler
