// SPDX-License-Identifier: MIT
#include "scene/scene_occluders.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "cover/placed.h"
#include "model/bounds.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {
namespace {

/// Why a mesh cannot stand there; empty if it can.
std::string fault(const OccluderMesh* mesh, const Placement& placement) {
  if (mesh == nullptr) return "an occluder without a mesh";
  const kernel::Aabb box = placed(placement, mesh->box());
  for (int axis = 0; axis < 3; ++axis) {
    // Not so if a number is NaN.
    if (box.min[axis] >= -kernel::kMaxMagnitude && box.max[axis] <= kernel::kMaxMagnitude) continue;
    return "an occluder's placement is not finite, or takes it beyond 2^100";
  }
  return {};
}

void require_placeable(const OccluderMesh* mesh, const Placement& placement) {
  if (const std::string reason = fault(mesh, placement); !reason.empty()) throw std::invalid_argument(reason);
}

/// The same for several, with the place. mesh_of(i) is the mesh of the i-th.
template <class MeshOf>
void require_placeable(const MeshOf& mesh_of, std::span<const Placement> placements) {
  for (std::size_t i = 0; i < placements.size(); ++i) {
    const std::string reason = fault(mesh_of(i), placements[i]);
    if (!reason.empty()) throw std::invalid_argument("placement " + std::to_string(i) + ": " + reason);
  }
}

}  // namespace

OccluderId SceneOccluders::add(std::shared_ptr<const OccluderMesh> mesh, const Placement& placement,
                               const OccluderOptions& options) {
  require_placeable(mesh.get(), placement);
  const OccluderId id = slots_.add({std::move(mesh), placement, options});
  changed(slots_[id]);
  return id;
}

void SceneOccluders::add(const std::shared_ptr<const OccluderMesh>& mesh, std::span<const Placement> placements,
                         const OccluderOptions& options, std::span<OccluderId> ids) {
  require_placeable([&](std::size_t) { return mesh.get(); }, placements);
  for (std::size_t i = 0; i < placements.size(); ++i) ids[i] = add(mesh, placements[i], options);
}

void SceneOccluders::remove(OccluderId id) {
  Placed& occluder = slots_[id];
  retired_.push_back(std::move(occluder.mesh));
  lost(occluder);
  slots_.remove(id);
}

void SceneOccluders::remove(std::span<const OccluderId> ids) {
  slots_.require(ids);
  for (const OccluderId id : ids) {
    if (contains(id)) remove(id);  // not so the second time
  }
}

void SceneOccluders::move(OccluderId id, const Placement& placement) {
  Placed& occluder = slots_[id];
  require_placeable(occluder.mesh.get(), placement);
  occluder.placement = placement;
  lost(occluder);
}

void SceneOccluders::move(std::span<const OccluderId> ids, std::span<const Placement> placements) {
  slots_.require(ids);
  require_placeable([&](std::size_t i) { return slots_[ids[i]].mesh.get(); }, placements);
  for (std::size_t i = 0; i < ids.size(); ++i) move(ids[i], placements[i]);
}

void SceneOccluders::replace(OccluderId id, std::shared_ptr<const OccluderMesh> mesh) {
  Placed& occluder = slots_[id];
  require_placeable(mesh.get(), occluder.placement);
  retired_.push_back(std::move(occluder.mesh));
  occluder.mesh = std::move(mesh);
  lost(occluder);
}

void SceneOccluders::set_enabled(OccluderId id, bool is_enabled) {
  Placed& occluder = slots_[id];
  occluder.is_enabled = is_enabled;
  lost(occluder);
}

void SceneOccluders::set_mask(OccluderId id, std::uint32_t mask) {
  Placed& occluder = slots_[id];
  occluder.options.mask = mask;
  lost(occluder);
}

bool SceneOccluders::update() {
  for (std::size_t forest = 0; forest < forests_.size(); ++forest) {
    if (has_changed_[forest]) build(forest);
  }
  has_changed_ = {};
  retired_.clear();
  return std::exchange(has_lost_, false);
}

void SceneOccluders::build(std::size_t forest) {
  BuildMemory& found = build_memory_;
  found.occluders.clear();
  found.boxes.clear();
  slots_.for_each([&](OccluderId id, const Placed& occluder) {
    const auto& [mesh, placement, options, is_enabled] = occluder;
    if (!is_enabled || mesh->size() == 0 || options.moves != (forest == 1)) return;
    found.occluders.push_back({id, mesh.get(), placement, options.mask, options.object, options.is_one_sided,
                               placement == Placement{}, is_mirrored(placement)});
    found.boxes.push_back(placed(placement, mesh->box()));
  });
  found.curve.sort(found.boxes);
  Forest& built = forests_[forest];
  built.tree.build(found.boxes, found.curve.order());
  built.occluders.clear();
  for (const std::uint32_t i : found.curve.order()) built.occluders.push_back(found.occluders[i]);
}

kernel::Aabb SceneOccluders::box() const {
  kernel::Aabb box = empty_box();
  for (const Forest& forest : forests_) grow(box, forest.tree.box());
  return box;
}

}  // namespace occlude::culler
