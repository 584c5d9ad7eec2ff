// SPDX-License-Identifier: MIT
// What is found out of an occluder's mesh once: a tree of its polygons, and which of their triangles share edges.
#pragma once

#include <optional>
#include <span>

#include "cover/cover_painter.h"
#include "cover/cover_triangles.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/culler/occluder_mesh.h"

namespace occlude::culler {

struct OccluderMesh::Prepared {
  std::optional<Hierarchy> tree;  ///< none of a mesh without polygons
  CoverTriangles triangles;

  [[nodiscard]] CoverSource source(const OccluderInstance& stand) const {
    return {tree ? tree->nodes() : std::span<const HierarchyNode>{}, triangles, stand};
  }
};

}  // namespace occlude::culler
