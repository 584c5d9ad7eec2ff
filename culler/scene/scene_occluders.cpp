// SPDX-License-Identifier: MIT
#include "scene/scene_occluders.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "base/bounds.h"
#include "cover/placed.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {
namespace {

void require_placeable(const std::shared_ptr<const OccluderMesh>& mesh, const Placement& placement) {
  if (!mesh) throw std::invalid_argument("an occluder without a mesh");
  const kernel::Aabb box = placed(placement, mesh->box());
  for (int axis = 0; axis < 3; ++axis) {
    // Not so if a number is NaN.
    if (box.min[axis] >= -kernel::kMaxMagnitude && box.max[axis] <= kernel::kMaxMagnitude) continue;
    throw std::invalid_argument("an occluder's placement is not finite, or takes it beyond 2^100");
  }
}

}  // namespace

OccluderId SceneOccluders::add(std::shared_ptr<const OccluderMesh> mesh, const Placement& placement,
                               const OccluderOptions& options) {
  require_placeable(mesh, placement);
  const OccluderId id = slots_.add({std::move(mesh), placement, options});
  changed(slots_[id]);
  return id;
}

void SceneOccluders::remove(OccluderId id) {
  Placed& occluder = slots_[id];
  retired_.push_back(std::move(occluder.mesh));
  changed(occluder);
  slots_.remove(id);
}

void SceneOccluders::move(OccluderId id, const Placement& placement) {
  Placed& occluder = slots_[id];
  require_placeable(occluder.mesh, placement);
  occluder.placement = placement;
  changed(occluder);
}

void SceneOccluders::replace(OccluderId id, std::shared_ptr<const OccluderMesh> mesh) {
  Placed& occluder = slots_[id];
  require_placeable(mesh, occluder.placement);
  retired_.push_back(std::move(occluder.mesh));
  occluder.mesh = std::move(mesh);
  changed(occluder);
}

void SceneOccluders::set_enabled(OccluderId id, bool is_enabled) {
  Placed& occluder = slots_[id];
  occluder.is_enabled = is_enabled;
  changed(occluder);
}

void SceneOccluders::set_mask(OccluderId id, std::uint32_t mask) {
  Placed& occluder = slots_[id];
  occluder.options.mask = mask;
  changed(occluder);
}

void SceneOccluders::update() {
  for (std::size_t forest = 0; forest < forests_.size(); ++forest) {
    if (has_changed_[forest]) build(forest);
  }
  has_changed_ = {};
  retired_.clear();
}

void SceneOccluders::build(std::size_t forest) {
  Forest& built = forests_[forest];
  built.occluders.clear();
  built.boxes.clear();
  slots_.for_each([&](OccluderId id, const Placed& occluder) {
    const auto& [mesh, placement, options, is_enabled] = occluder;
    if (!is_enabled || mesh->size() == 0 || options.moves != (forest == 1)) return;
    built.occluders.push_back({id, mesh.get(), placement, options.mask, options.object, options.is_one_sided,
                               placement == Placement{}, is_mirrored(placement)});
    built.boxes.push_back(placed(placement, mesh->box()));
  });
  built.tree.build(built.boxes, 1);
}

kernel::Aabb SceneOccluders::box() const {
  kernel::Aabb box = empty_box();
  for (const Forest& forest : forests_) {
    if (!forest.tree.nodes().empty()) grow(box, forest.tree.nodes()[0].box);
  }
  return box;
}

}  // namespace occlude::culler
