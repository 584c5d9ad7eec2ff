// SPDX-License-Identifier: MIT
#include "cover/cover_group.h"

namespace occlude::culler {

void CoverGroup::reserve(std::size_t triangles) {
  vertex_index_.reserve(triangles);  // meshes have fewer vertices than triangles, and a small table is a fast one
  triangle_index_.reserve(triangles);
  vertices_.reserve(3 * triangles);
  triangles_.reserve(triangles);
  next_.reserve(3 * triangles);
  ids_.reserve(triangles);
}

void CoverGroup::clear() {
  vertex_index_.clear();
  triangle_index_.clear();
  vertices_.clear();
  triangles_.clear();
  ids_.clear();
  own_ = 0;
}

void CoverGroup::add(const CoverTriangles& triangles, std::uint32_t polygon, const OccluderInstance& instance) {
  for (std::uint32_t t = triangles.first(polygon); t < triangles.first(polygon + 1); ++t) {
    add_triangle(triangles, t, instance);
  }
  own_ = ids_.size();
}

/// Adds a triangle if its corners are three points.
void CoverGroup::add_triangle(const CoverTriangles& triangles, std::uint32_t id, const OccluderInstance& instance) {
  const CoverMesh::Triangle& corners = triangles.corners(id);
  if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) return;
  CoverMesh::Triangle own{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t known = vertex_index_.size();
    own[i] = vertex_index_.number(corners[i]);
    if (own[i] != known) continue;
    vertices_.push_back(instance.place(triangles.vertex(corners[i])));
  }
  triangle_index_.number(id);
  triangles_.push_back(own);
  ids_.push_back(id);
}

CoverMesh CoverGroup::mesh(const CoverTriangles& triangles, const OccluderInstance& instance) {
  next_.assign(3 * triangles_.size(), LocalIndex::kNone);
  for (std::uint32_t side = 0; side < next_.size(); ++side) {
    if (next_[side] != LocalIndex::kNone) continue;  // the second of two
    // Follows the ring to the next side of a triangle of the group. Without another one, that is the side itself.
    RingStep step = triangles.next(3 * ids_[side / 3] + side % 3);
    std::uint32_t owner = triangle_index_.find(step.side / 3);
    while (owner == LocalIndex::kNone && step.is_of_two == 0) {
      step = triangles.next(step.side);
      owner = triangle_index_.find(step.side / 3);
    }
    next_[side] = owner == LocalIndex::kNone ? side : 3 * owner + step.side % 3;
    if (step.is_of_two != 0) next_[next_[side]] = side;
  }
  return {vertices_, triangles_, next_, own_, instance.front};
}

}  // namespace occlude::culler
