// SPDX-License-Identifier: MIT
#include "scene/scene_occluders.h"

#include <stdexcept>
#include <string>
#include <utility>

#include "cover/placed.h"
#include "cover/prepared_mesh.h"
#include "occlude/kernel/validity.h"
#include "scene/scene_box.h"

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

/// Where it is; none if there is nothing of it.
SceneBox place_of(const OccluderMesh& mesh, const Placement& placement) {
  if (mesh.size() == 0) return {};
  return SceneBox::of(placed(placement, mesh.box()));
}

}  // namespace

OccluderId SceneOccluders::add(std::shared_ptr<const OccluderMesh> mesh, const Placement& placement,
                               const OccluderOptions& options) {
  require_placeable(mesh.get(), placement);
  make_room(placed_, 4);
  make_room(changed_, 4);
  const OccluderId id = boxes_.add(place_of(*mesh, placement), {.moves = options.moves, .mask = options.mask});
  if (placed_.size() <= id.slot()) placed_.resize(id.slot() + std::size_t{1});
  meshes_ += size_of(*mesh);
  placed_[id.slot()] = {id, std::move(mesh), placement, options.object, options.moves, options.is_one_sided};
  changed(id);
  return id;
}

void SceneOccluders::add(const std::shared_ptr<const OccluderMesh>& mesh, std::span<const Placement> placements,
                         const OccluderOptions& options, std::span<OccluderId> ids) {
  require_placeable([&](std::size_t) { return mesh.get(); }, placements);
  for (std::size_t i = 0; i < placements.size(); ++i) ids[i] = add(mesh, placements[i], options);
}

void SceneOccluders::remove(OccluderId id) {
  Placed& occluder = placed_of(id);
  retire(occluder);
  lost(occluder);
  boxes_.remove(id);
  occluder = {};
}

void SceneOccluders::remove(std::span<const OccluderId> ids) {
  boxes_.require(ids);
  for (const OccluderId id : ids) {
    if (contains(id)) remove(id);  // not so the second time
  }
}

void SceneOccluders::move(OccluderId id, const Placement& placement) {
  Placed& occluder = placed_of(id);
  require_placeable(occluder.mesh.get(), placement);
  boxes_.move(id, place_of(*occluder.mesh, placement));
  occluder.placement = placement;
  changed(id);
  lost(occluder);
}

void SceneOccluders::move(std::span<const OccluderId> ids, std::span<const Placement> placements) {
  boxes_.require(ids);
  require_placeable([&](std::size_t i) { return placed_of(ids[i]).mesh.get(); }, placements);
  for (std::size_t i = 0; i < ids.size(); ++i) move(ids[i], placements[i]);
}

void SceneOccluders::replace(OccluderId id, std::shared_ptr<const OccluderMesh> mesh) {
  Placed& occluder = placed_of(id);
  require_placeable(mesh.get(), occluder.placement);
  boxes_.move(id, place_of(*mesh, occluder.placement));
  retire(occluder);
  meshes_ += size_of(*mesh);
  occluder.mesh = std::move(mesh);
  changed(id);
  lost(occluder);
}

void SceneOccluders::set_enabled(OccluderId id, bool is_enabled) {
  boxes_.set_enabled(id, is_enabled);
  lost(placed_of(id));
}

void SceneOccluders::set_mask(OccluderId id, std::uint32_t mask) {
  boxes_.set_mask(id, mask);
  lost(placed_of(id));
}

SceneOccluders::Placed& SceneOccluders::placed_of(OccluderId id) {
  if (!contains(id)) throw std::invalid_argument(fault(id));
  return placed_[id.slot()];
}

/// Takes its mesh away.
void SceneOccluders::retire(Placed& occluder) {
  meshes_ -= size_of(*occluder.mesh);
  retired_.push_back(std::move(occluder.mesh));
}

bool SceneOccluders::update(const Executor& executor) {
  boxes_.update(executor);
  standing_.resize(placed_.size());
  for (const std::uint32_t slot : changed_) {
    const Placed& occluder = placed_[slot];
    if (occluder.id.is_none()) continue;  // it was removed again
    standing_[slot] = {occluder.id,
                       occluder.mesh.get(),
                       occluder.placement,
                       occluder.object,
                       occluder.is_one_sided,
                       occluder.placement == Placement{},
                       is_mirrored(occluder.placement)};
  }
  changed_.clear();
  retired_.clear();
  seen_meshes_ = meshes_;
  return std::exchange(has_lost_, false);
}

}  // namespace occlude::culler
