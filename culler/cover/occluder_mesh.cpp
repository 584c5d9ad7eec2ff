// SPDX-License-Identifier: MIT
#include "occlude/culler/occluder_mesh.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "cover/prepared_mesh.h"
#include "model/legal_soup.h"
#include "occlude/culler/cull_result.h"

namespace occlude::culler {
namespace {

void drop_negligible(PolygonSoup& soup) {
  for (glm::dvec3& vertex : soup.vertices) {
    for (int axis = 0; axis < 3; ++axis) {
      vertex[axis] = kernel::flushed(vertex[axis]);
    }
  }
}

std::size_t nodes_above_few(const BlockTree& tree) {
  std::size_t nodes = 0;
  for (std::uint32_t i = 0; i < tree.size(); ++i) {
    if (tree[i].items().count > kFewItems) nodes += tree[i].size();
  }
  return nodes;
}

std::unique_ptr<const OccluderMesh::Prepared> prepared(PolygonSoup&& soup, const Checkpoint& checkpoint) {
  drop_negligible(soup);
  require_legal(soup);
  auto result = std::make_unique<OccluderMesh::Prepared>();
  if (soup.empty()) return result;
  result->tree = Hierarchy::build(std::move(soup), {.leaf_size = leaf_size_for(Method::cover)}, checkpoint);
  result->blocks = HierarchyBlocks(*result->tree, checkpoint);
  result->triangles = CoverTriangles::find(result->tree->soup(), checkpoint);
  result->size = {result->triangles.size(), nodes_above_few(result->blocks.tree())};
  return result;
}

}  // namespace

OccluderMesh::OccluderMesh(PolygonSoup soup, const Checkpoint& checkpoint)
    : prepared_(occlude::culler::prepared(std::move(soup), checkpoint)) {}
OccluderMesh::~OccluderMesh() = default;

std::size_t OccluderMesh::size() const { return prepared_->tree ? prepared_->tree->soup().size() : 0; }

kernel::Aabb OccluderMesh::box() const { return prepared_->tree ? prepared_->tree->nodes()[0].box : kernel::Aabb{}; }

const OccluderMesh::Prepared& prepared_of(const OccluderMesh& mesh) { return *mesh.prepared_; }

}  // namespace occlude::culler
