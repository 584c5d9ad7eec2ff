// SPDX-License-Identifier: MIT
// What is found out of an occluder's mesh once: a tree of its polygons, and which of their triangles share edges.
#pragma once

#include <optional>

#include "cover/cover_triangles.h"
#include "model/hierarchy_blocks.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/culler/occluder_mesh.h"

namespace occlude::culler {

struct OccluderMesh::Prepared {
  std::optional<Hierarchy> tree;  ///< none of a mesh without polygons
  HierarchyBlocks blocks;         ///< of the tree
  CoverTriangles triangles;
};

[[nodiscard]] const OccluderMesh::Prepared& prepared_of(const OccluderMesh& mesh);

}  // namespace occlude::culler
