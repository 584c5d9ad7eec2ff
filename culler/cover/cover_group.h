// SPDX-License-Identifier: MIT
// Triangles that are drawn into a cover buffer together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/local_index.h"
#include "cover/cover_mesh.h"
#include "cover/cover_triangles.h"
#include "cover/placed.h"
#include "model/bounds.h"

namespace occlude::culler {

/// How polygons stand in a scene: where, and which of their sides hide.
struct OccluderInstance {
  const Placement* placement = nullptr;  ///< nullptr: where their vertices are
  CoverMesh::Front front = CoverMesh::Front::both;

  /// Where a vertex of theirs is in the scene.
  [[nodiscard]] glm::dvec3 place(const glm::dvec3& vertex) const {
    return placement == nullptr ? vertex : to_glm(placed(*placement, to_kernel(vertex)));
  }
};

/// Builds the mesh of a few polygons, and of triangles that touch them.
class CoverGroup {
 public:
  /// Thousands may meet at a corner. Without a limit frames would take quadratic time.
  static constexpr std::size_t kMostAround = 8;

  /// Reserves memory for this many triangles.
  void reserve(std::size_t triangles);
  /// Forgets all triangles.
  void clear();
  /// REQUIRES: the polygon was not added since clear(); `triangles` and `instance` are the same in all calls since then.
  void add(const CoverTriangles& triangles, std::uint32_t polygon, const OccluderInstance& instance = {});
  /// Adds triangles that have a corner in common with the polygons, are connected with them by edges at such corners, and
  /// for which take(triangle) is true, which it must not be of any in the group. Adds at most kMostAround for each of the
  /// polygons' own. REQUIRES: as add(), whose calls are done.
  template <class Take>
  void add_neighbours(const CoverTriangles& triangles, const OccluderInstance& instance, const Take& take) {
    const std::uint32_t own_vertices = vertex_index_.size();
    const std::size_t most = (1 + kMostAround) * own_;
    for (std::size_t t = 0; t < ids_.size(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        if (triangles_[t][i] >= own_vertices && triangles_[t][(i + 1) % 3] >= own_vertices) continue;
        const std::uint32_t side = 3 * ids_[t] + i;
        for (RingStep step = triangles.next(side); step.side != side; step = triangles.next(step.side)) {
          if (ids_.size() == most) return;
          if (take(step.side / 3)) add_triangle(triangles, step.side / 3, instance);
          if (step.is_of_two != 0) break;
        }
      }
    }
  }
  [[nodiscard]] bool is_empty() const { return triangles_.empty(); }

  /// The mesh of all that was added. It is valid until the next call of clear() or add().
  [[nodiscard]] CoverMesh mesh(const CoverTriangles& triangles, const OccluderInstance& instance = {});
  /// For each triangle of the mesh, its number among all triangles.
  [[nodiscard]] std::span<const std::uint32_t> ids() const { return ids_; }

 private:
  void add_triangle(const CoverTriangles& triangles, std::uint32_t id, const OccluderInstance& instance);

  LocalIndex vertex_index_, triangle_index_;
  std::vector<glm::dvec3> vertices_;
  std::vector<CoverMesh::Triangle> triangles_;
  std::vector<std::uint32_t> next_;  ///< of each side, as the mesh has it
  std::vector<std::uint32_t> ids_;
  std::size_t own_ = 0;  ///< triangles of polygons, which are the first
};

}  // namespace occlude::culler
