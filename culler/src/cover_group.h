// SPDX-License-Identifier: MIT
// Polygons that are drawn into a cover buffer together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cover_mesh.h"
#include "cover_triangles.h"
#include "local_index.h"

namespace occlude::culler {

/// Gathers the mesh of a few polygons.
class CoverGroup {
 public:
  /// Makes room for so many triangles.
  void reserve(std::size_t triangles);
  /// Forgets all polygons.
  void clear();
  /// REQUIRES: the polygon was not added since clear(); the same triangles for all.
  void add(const CoverTriangles& triangles, std::uint32_t polygon);
  [[nodiscard]] bool is_empty() const { return triangles_.empty(); }

  /// Of all that was added. It holds until the next call of clear() or add().
  [[nodiscard]] CoverMesh mesh(const CoverTriangles& triangles);
  /// Of each triangle of the mesh, the polygon that it is part of.
  [[nodiscard]] std::span<const std::uint32_t> polygons() const { return polygons_; }

 private:
  LocalIndex vertex_index_, triangle_index_;
  std::vector<glm::dvec3> vertices_;
  std::vector<CoverMesh::Triangle> triangles_;
  std::vector<CoverMesh::Next> next_;
  std::vector<std::uint32_t> polygons_, ids_;  ///< of the triangles: the polygon, and which of all triangles it is
};

}  // namespace occlude::culler
