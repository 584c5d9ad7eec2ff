// SPDX-License-Identifier: MIT
// What is found out of an occluder's mesh once: a tree of its polygons, and which of their triangles share edges.
#pragma once

#include <cstddef>
#include <optional>

#include "cover/cover_triangles.h"
#include "model/hierarchy_blocks.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/culler/occluder_mesh.h"

namespace occlude::culler {

/// How much a frame may have to do with a mesh, or with several.
struct MeshSize {
  std::size_t triangles = 0;
  std::size_t nodes = 0;  ///< of its tree, but those in subtrees of few items

  MeshSize& operator+=(const MeshSize& more) { return *this = {triangles + more.triangles, nodes + more.nodes}; }
  MeshSize& operator-=(const MeshSize& less) { return *this = {triangles - less.triangles, nodes - less.nodes}; }
};

struct OccluderMesh::Prepared {
  std::optional<Hierarchy> tree;  ///< none of a mesh without polygons
  HierarchyBlocks blocks;         ///< of the tree
  CoverTriangles triangles;
  MeshSize size;
};

[[nodiscard]] const OccluderMesh::Prepared& prepared_of(const OccluderMesh& mesh);
[[nodiscard]] inline const MeshSize& size_of(const OccluderMesh& mesh) { return prepared_of(mesh).size; }

}  // namespace occlude::culler
