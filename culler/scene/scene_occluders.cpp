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
  const SceneBox box = options.weld != 0 ? SceneBox() : place_of(*mesh, placement);
  const OccluderId id = boxes_.add(box, {.moves = options.moves, .mask = options.mask});
  if (placed_.size() <= id.slot()) placed_.resize(id.slot() + std::size_t{1});
  Placed& occluder = placed_[id.slot()];
  occluder = {id, std::move(mesh), placement, options};
  if (is_welded(occluder)) {
    join_weld(occluder);
  } else {
    meshes_ += size_of(*occluder.mesh);
  }
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
  leave_weld(occluder);
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
  occluder.placement = placement;
  stand_again(occluder);
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
  retire(occluder);
  occluder.mesh = std::move(mesh);
  if (!is_welded(occluder)) meshes_ += size_of(*occluder.mesh);
  stand_again(occluder);
  changed(id);
  lost(occluder);
}

void SceneOccluders::set_enabled(OccluderId id, bool is_enabled) {
  boxes_.set_enabled(id, is_enabled);
  change_layers(placed_of(id), [&](Placed& occluder) { occluder.is_enabled = is_enabled; });
}

void SceneOccluders::set_mask(OccluderId id, std::uint32_t mask) {
  boxes_.set_mask(id, mask);
  change_layers(placed_of(id), [&](Placed& occluder) { occluder.options.mask = mask; });
}

template <class Change>
void SceneOccluders::change_layers(Placed& occluder, const Change& change) {
  leave_weld(occluder);
  change(occluder);
  join_weld(occluder);
  lost(occluder);
}

SceneOccluders::Placed& SceneOccluders::placed_of(OccluderId id) {
  if (!contains(id)) throw std::invalid_argument(fault(id));
  return placed_[id.slot()];
}

/// Takes its mesh away.
void SceneOccluders::retire(Placed& occluder) {
  if (!is_welded(occluder)) meshes_ -= size_of(*occluder.mesh);
  retired_.push_back(std::move(occluder.mesh));
}

/// Its mesh or its placement is another one.
void SceneOccluders::stand_again(const Placed& occluder) {
  if (!is_welded(occluder)) {
    boxes_.move(occluder.id, place_of(*occluder.mesh, occluder.placement));
  } else if (occluder.is_enabled) {
    changed_welds_.insert(key_of(occluder));
  }
}

SceneOccluders::WeldKey SceneOccluders::key_of(const Placed& occluder) {
  const OccluderOptions& options = occluder.options;
  return {options.weld, options.mask, options.object, options.moves, options.is_one_sided};
}

void SceneOccluders::join_weld(const Placed& occluder) {
  if (!is_welded(occluder) || !occluder.is_enabled) return;
  const WeldKey key = key_of(occluder);
  welds_[key].members.insert(occluder.id.slot());
  changed_welds_.insert(key);
}

void SceneOccluders::leave_weld(const Placed& occluder) {
  if (!is_welded(occluder) || !occluder.is_enabled) return;
  const WeldKey key = key_of(occluder);
  welds_[key].members.erase(occluder.id.slot());
  changed_welds_.insert(key);
}

/// Of all members, where they stand; none if there are none.
std::unique_ptr<const WeldedMesh> SceneOccluders::mesh_of(const Weld& weld, const Executor& executor) const {
  if (weld.members.empty()) return nullptr;
  std::vector<WeldedPart> parts;
  for (const std::uint32_t slot : weld.members) {
    const Placed& occluder = placed_[slot];
    parts.push_back({occluder.id, occluder.mesh.get(), &occluder.placement});
  }
  return std::make_unique<WeldedMesh>(parts, executor);
}

/// Makes the meshes of welds that have changed, which may throw. Then all of these leave their places before any takes one,
/// because an occluder that stood for a weld may now stand for another.
void SceneOccluders::weld_again(const Executor& executor) {
  std::vector<std::unique_ptr<const WeldedMesh>> made;
  for (const WeldKey& key : changed_welds_) made.push_back(mesh_of(welds_[key], executor));
  for (const WeldKey& key : changed_welds_) leave_place(welds_[key]);
  auto mesh = made.begin();
  for (const WeldKey& key : changed_welds_) {
    if (*mesh == nullptr) {
      welds_.erase(key);
    } else {
      take_place(welds_[key], std::move(*mesh));
    }
    ++mesh;
  }
  changed_welds_.clear();
}

void SceneOccluders::leave_place(Weld& weld) {
  if (weld.mesh) meshes_ -= size_of(weld.mesh->mesh());
  if (boxes_.contains(weld.stands)) boxes_.move(weld.stands, {});
  weld.mesh.reset();
}

void SceneOccluders::take_place(Weld& weld, std::unique_ptr<const WeldedMesh> of_members) {
  weld.mesh = std::move(of_members);
  weld.stands = placed_[*weld.members.begin()].id;
  const OccluderMesh& mesh = weld.mesh->mesh();
  meshes_ += size_of(mesh);
  boxes_.move(weld.stands, place_of(mesh, {}));
  changed(weld.stands);
}

SceneOccluders::Standing SceneOccluders::standing_of(const Placed& occluder) const {
  Standing standing{occluder.id, occluder.mesh.get(), occluder.placement, occluder.options.object,
                    occluder.options.is_one_sided};
  if (is_welded(occluder) && occluder.is_enabled) {
    const Weld& weld = welds_.at(key_of(occluder));
    if (weld.stands == occluder.id) {
      standing.welded = weld.mesh.get();
      standing.mesh = &weld.mesh->mesh();
      standing.placement = {};
    }
  }
  standing.is_identity = standing.placement == Placement{};
  standing.is_mirrored = is_mirrored(standing.placement);
  standing.edition = edition_;
  return standing;
}

bool SceneOccluders::update(const Executor& executor) {
  weld_again(executor);
  boxes_.update(executor);
  standing_.resize(placed_.size());
  if (!changed_.empty()) ++edition_;
  for (const std::uint32_t slot : changed_) {
    const Placed& occluder = placed_[slot];
    if (occluder.id.is_none()) continue;  // it was removed again
    standing_[slot] = standing_of(occluder);
  }
  changed_.clear();
  retired_.clear();
  seen_meshes_ = meshes_;
  return std::exchange(has_lost_, false);
}

}  // namespace occlude::culler
