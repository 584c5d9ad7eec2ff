// SPDX-License-Identifier: MIT
#include "model_scene.h"

#include <memory>
#include <variant>

#include "occlude/render/witness.h"

namespace occlude::cli {
namespace {

/// The soup in memory of its own, with the same numbers.
culler::PolygonSoup copied(const culler::SoupView& soup) {
  culler::PolygonSoup copy;
  copy.vertices.assign(soup.vertices.begin(), soup.vertices.end());
  copy.indices.assign(soup.indices.begin(), soup.indices.end());
  copy.first.assign(soup.first.begin(), soup.first.end());
  copy.see_through.assign(soup.see_through.begin(), soup.see_through.end());
  return copy;
}

}  // namespace

ModelScene::ModelScene(const culler::Hierarchy& hierarchy) : hierarchy_(hierarchy) {
  std::vector<culler::Box> boxes;
  std::vector<culler::PolygonRange> leaves;
  for (const culler::HierarchyNode& node : hierarchy.nodes()) {
    if (!node.is_leaf()) continue;
    leaves.push_back({node.first, node.count});
    boxes.emplace_back(node.box);
  }
  std::vector<culler::ObjectId> ids(boxes.size());
  scene_.add(boxes, {}, ids);
  objects_.resize(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) objects_[ids[i].slot()] = leaves[i];
  scene_.add(std::make_shared<culler::OccluderMesh>(copied(hierarchy.soup())));
  scene_.update();
}

void ModelScene::append_witnesses(std::vector<std::string>& lines, std::size_t frame, const proof::AnyCamera& camera,
                                  const culler::CullOptions& options) {
  const culler::SceneOptions same{.cover = options.cover, .margin = options.margin};
  const auto of = [&](const auto& c) {
    std::vector<culler::ObjectWitness> witnesses;
    const culler::SceneResult& result = scene_.cull(c, same, view_);
    scene_.append_witnesses(c, same, view_, witnesses);
    render::append_witnesses(lines, frame, camera, hierarchy_, result.view, witnesses, objects_);
  };
  std::visit(of, camera);
}

}  // namespace occlude::cli
