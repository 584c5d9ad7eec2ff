// SPDX-License-Identifier: MIT
// The meshes that are drawn into a cover buffer: of each small subtree its polygons and those that touch them.
//
// A mesh closes pixels across the edges that its triangles share. So that none stays open between two meshes, each has the
// polygons about it as well: a polygon is in as many of them as it touches.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "cover_mesh.h"
#include "occlude/culler/checkpoint.h"
#include "occlude/culler/hierarchy.h"

namespace occlude::culler {

/// May be asked on several threads at once.
class CoverPieces {
 public:
  /// Most polygons of a subtree that is one mesh; a leaf is one however many it has. Smaller ones are drawn more often
  /// beside what is seen than needed less, and larger ones are farther at their far end.
  static constexpr std::uint32_t kMost = 32;

  CoverPieces() = default;
  [[nodiscard]] static CoverPieces find(const PolygonSoup& soup, std::span<const HierarchyNode> nodes,
                                        const Checkpoint& checkpoint = {});

  [[nodiscard]] std::size_t size() const { return begins_.size() - 1; }
  [[nodiscard]] CoverMesh operator[](std::size_t mesh) const;
  /// The mesh of the leaf that has the polygon.
  [[nodiscard]] std::uint32_t mesh_of(std::uint32_t polygon) const { return mesh_of_[polygon]; }
  /// The polygon that a triangle of a mesh is part of.
  [[nodiscard]] std::uint32_t polygon(std::size_t mesh, std::size_t triangle) const {
    return polygons_[begins_[mesh].triangle + triangle];
  }

 private:
  /// Where the parts of a mesh begin; they end where those of the next do.
  struct Begin {
    std::size_t vertex = 0, triangle = 0, edge = 0, use = 0;
  };
  class Finder;

  std::vector<Begin> begins_ = {{}};
  std::vector<std::uint32_t> mesh_of_;
  std::vector<glm::dvec3> vertices_;
  std::vector<CoverMesh::Triangle> triangles_;
  std::vector<std::uint32_t> polygons_;
  std::vector<std::uint8_t> is_closed_;
  std::vector<CoverMesh::Edge> edges_;
  std::vector<CoverMesh::Use> uses_;
};

}  // namespace occlude::culler
