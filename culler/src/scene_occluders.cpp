// SPDX-License-Identifier: MIT
#include "scene_occluders.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "bounds.h"
#include "occlude/kernel/validity.h"
#include "placed.h"

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

bool SceneOccluders::contains(OccluderId id) const {
  return id.slot < slots_.size() && slots_[id.slot].is_used && slots_[id.slot].generation == id.generation;
}

SceneOccluders::Slot& SceneOccluders::slot(OccluderId id) {
  if (!contains(id)) throw std::invalid_argument("the scene has no such occluder");
  return slots_[id.slot];
}

OccluderId SceneOccluders::add(std::shared_ptr<const OccluderMesh> mesh, const Placement& placement,
                               const OccluderOptions& options) {
  require_placeable(mesh, placement);
  if (free_slots_.empty()) {
    slots_.emplace_back();
    free_slots_.push_back(static_cast<std::uint32_t>(slots_.size() - 1));
  }
  const std::uint32_t i = free_slots_.back();
  free_slots_.pop_back();
  slots_[i] = {slots_[i].generation, true, true, options, placement, std::move(mesh)};
  ++size_;
  changed(slots_[i]);
  return {i, slots_[i].generation};
}

void SceneOccluders::remove(OccluderId id) {
  Slot& slot = this->slot(id);
  retired_.push_back(std::move(slot.mesh));
  slot.is_used = false;
  --size_;
  changed(slot);
  // A slot whose generations have all been used is not used again.
  if (++slot.generation != 0) free_slots_.push_back(id.slot);
}

void SceneOccluders::move(OccluderId id, const Placement& placement) {
  Slot& slot = this->slot(id);
  require_placeable(slot.mesh, placement);
  slot.placement = placement;
  changed(slot);
}

void SceneOccluders::replace(OccluderId id, std::shared_ptr<const OccluderMesh> mesh) {
  Slot& slot = this->slot(id);
  require_placeable(mesh, slot.placement);
  retired_.push_back(std::move(slot.mesh));
  slot.mesh = std::move(mesh);
  changed(slot);
}

void SceneOccluders::set_enabled(OccluderId id, bool is_enabled) {
  Slot& slot = this->slot(id);
  slot.is_enabled = is_enabled;
  changed(slot);
}

void SceneOccluders::set_mask(OccluderId id, std::uint32_t mask) {
  Slot& slot = this->slot(id);
  slot.options.mask = mask;
  changed(slot);
}

void SceneOccluders::update() {
  for (std::size_t forest = 0; forest < forests_.size(); ++forest) {
    if (has_changed_[forest]) build(forest);
  }
  has_changed_ = {};
  retired_.clear();
}

void SceneOccluders::build(std::size_t forest) {
  auto& [tree, occluders, boxes] = forests_[forest];
  occluders.clear();
  boxes.clear();
  for (std::uint32_t i = 0; i < slots_.size(); ++i) {
    const Slot& slot = slots_[i];
    if (!slot.is_used || !slot.is_enabled || slot.mesh->size() == 0) continue;
    if (slot.options.moves != (forest == 1)) continue;
    const OccluderOptions& options = slot.options;
    occluders.push_back({{i, slot.generation},
                         slot.mesh.get(),
                         slot.placement,
                         options.mask,
                         options.object,
                         options.is_one_sided,
                         slot.placement == Placement{},
                         is_mirrored(slot.placement)});
    boxes.push_back(placed(slot.placement, slot.mesh->box()));
  }
  tree.build(boxes, 1);
}

kernel::Aabb SceneOccluders::box() const {
  kernel::Aabb box = empty_box();
  for (const Forest& forest : forests_) {
    if (!forest.tree.nodes().empty()) grow(box, forest.tree.nodes()[0].box);
  }
  return box;
}

}  // namespace occlude::culler
