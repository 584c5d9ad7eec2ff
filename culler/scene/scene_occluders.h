// SPDX-License-Identifier: MIT
// The occluders of a scene: what the caller changes, and what views see of it since the last update.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "cover/prepared_mesh.h"
#include "occlude/culler/box.h"
#include "occlude/culler/executor.h"
#include "occlude/culler/occluder_mesh.h"
#include "occlude/culler/scene.h"
#include "scene/scene_things.h"
#include "scene/welded_mesh.h"

namespace occlude::culler {

/// The boxes of occluders are kept as those of objects are; what stands in them is kept by slots. As with SceneThings,
/// changes touch only what no view sees. Of the occluders of a weld one stands where all of them are, with a mesh of all.
class SceneOccluders {
 public:
  explicit SceneOccluders(SceneNumber& scene) : boxes_(scene) {}

  OccluderId add(std::shared_ptr<const OccluderMesh> mesh, const Placement& placement, const OccluderOptions& options);
  void add(const std::shared_ptr<const OccluderMesh>& mesh, std::span<const Placement> placements,
           const OccluderOptions& options, std::span<OccluderId> ids);
  void remove(OccluderId id);
  void remove(std::span<const OccluderId> ids);
  void move(OccluderId id, const Placement& placement);
  void move(std::span<const OccluderId> ids, std::span<const Placement> placements);
  void replace(OccluderId id, std::shared_ptr<const OccluderMesh> mesh);
  void set_enabled(OccluderId id, bool is_enabled);
  void set_mask(OccluderId id, std::uint32_t mask);
  [[nodiscard]] bool contains(OccluderId id) const { return boxes_.contains(id); }
  [[nodiscard]] std::string fault(OccluderId id) const { return boxes_.fault(id); }
  [[nodiscard]] std::size_t size() const { return boxes_.size(); }

  /// Returns whether something that stands still hides no longer as it did.
  bool update(const Executor& executor);

  /// Where they are, as views see it, and in which layers. Those of meshes without polygons have no place.
  [[nodiscard]] const SceneThings<SceneKind::occluder>& boxes() const { return boxes_; }
  /// An occluder as views see it.
  struct Standing {
    OccluderId id;
    const OccluderMesh* mesh = nullptr;
    Placement placement;
    ObjectId object;
    bool is_one_sided = false, is_identity = true, is_mirrored = false;
    std::uint64_t edition = 0;           ///< since which it is so
    const WeldedMesh* welded = nullptr;  ///< of which it has the mesh, if it stands for a weld

    /// The occluder that has a polygon, and its number in the soup of that one's mesh. `number` is that in the soup of
    /// `mesh`.
    [[nodiscard]] WeldedMesh::Polygon polygon(std::uint32_t number) const {
      return welded == nullptr ? WeldedMesh::Polygon{id, number} : welded->polygon(number);
    }
  };
  /// REQUIRES: it is in a group of boxes().
  [[nodiscard]] const Standing& standing(OccluderId id) const { return standing_[id.slot()]; }
  /// Grows with each update in which one was added, moved or replaced.
  [[nodiscard]] std::uint64_t edition() const { return edition_; }
  /// Slots of all of them are less.
  [[nodiscard]] std::size_t slots() const { return standing_.size(); }
  /// The sizes of all meshes together, once for each occluder: no frame draws or asks more.
  [[nodiscard]] const MeshSize& meshes() const { return seen_meshes_; }

 private:
  /// What the caller has made of an occluder.
  struct Placed {
    OccluderId id;
    std::shared_ptr<const OccluderMesh> mesh;
    Placement placement;
    OccluderOptions options;
    bool is_enabled = true;
  };

  /// Occluders are welded that have the same options.
  struct WeldKey {
    std::uint32_t weld, mask;
    ObjectId object;
    bool moves, is_one_sided;

    friend auto operator<=>(const WeldKey&, const WeldKey&) = default;
  };
  struct Weld {
    std::set<std::uint32_t> members;         ///< slots of those that are enabled
    std::unique_ptr<const WeldedMesh> mesh;  ///< as views see it
    OccluderId stands;                       ///< the member in whose place the mesh is; the others have no place
  };

  [[nodiscard]] Placed& placed_of(OccluderId id);
  void changed(OccluderId id) { changed_.push_back(id.slot()); }
  /// It may hide less than before.
  void lost(const Placed& occluder) { has_lost_ = has_lost_ || !occluder.options.moves; }
  void retire(Placed& occluder);
  template <class Change>
  void change_layers(Placed& occluder, const Change& change);
  void stand_again(const Placed& occluder);

  [[nodiscard]] static bool is_welded(const Placed& occluder) { return occluder.options.weld != 0; }
  [[nodiscard]] static WeldKey key_of(const Placed& occluder);
  void join_weld(const Placed& occluder);
  void leave_weld(const Placed& occluder);
  [[nodiscard]] std::unique_ptr<const WeldedMesh> mesh_of(const Weld& weld, const Executor& executor) const;
  void weld_again(const Executor& executor);
  void leave_place(Weld& weld);
  void take_place(Weld& weld, std::unique_ptr<const WeldedMesh> of_members);
  [[nodiscard]] Standing standing_of(const Placed& occluder) const;

  // Of the caller.
  SceneThings<SceneKind::occluder> boxes_;
  std::vector<Placed> placed_;                                ///< by slots
  std::vector<std::uint32_t> changed_;                        ///< slots of what is not yet as placed_ has it
  std::vector<std::shared_ptr<const OccluderMesh>> retired_;  ///< which views may still see
  MeshSize meshes_;
  bool has_lost_ = false;
  std::map<WeldKey, Weld> welds_;
  std::set<WeldKey> changed_welds_;

  // Of the views.
  std::vector<Standing> standing_;  ///< by slots
  MeshSize seen_meshes_;
  std::uint64_t edition_ = 0;
};

}  // namespace occlude::culler
