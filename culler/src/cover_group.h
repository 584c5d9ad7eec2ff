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

struct Placement;

/// How polygons stand in a scene: where, and which of their sides hide.
struct CoverStand {
  const Placement* placement = nullptr;  ///< nullptr: where their vertices are
  CoverMesh::Front front = CoverMesh::Front::both;
};

/// Builds the mesh of a few polygons.
class CoverGroup {
 public:
  /// Reserves memory for this many triangles.
  void reserve(std::size_t triangles);
  /// Forgets all polygons.
  void clear();
  /// REQUIRES: the polygon was not added since clear(); `triangles` and `stand` are the same in all calls since then.
  void add(const CoverTriangles& triangles, std::uint32_t polygon, const CoverStand& stand = {});
  [[nodiscard]] bool is_empty() const { return triangles_.empty(); }

  /// The mesh of all that was added. It is valid until the next call of clear() or add().
  [[nodiscard]] CoverMesh mesh(const CoverTriangles& triangles, const CoverStand& stand = {});
  /// For each triangle of the mesh, its polygon.
  [[nodiscard]] std::span<const std::uint32_t> polygons() const { return polygons_; }

 private:
  LocalIndex vertex_index_, triangle_index_;
  std::vector<glm::dvec3> vertices_;
  std::vector<CoverMesh::Triangle> triangles_;
  std::vector<std::uint32_t> next_;            ///< of each side, as the mesh has it
  std::vector<std::uint32_t> polygons_, ids_;  ///< for each triangle: its polygon, and its number among all triangles
};

}  // namespace occlude::culler
