// SPDX-License-Identifier: MIT
// The occluders of a scene: what the caller changes, and what views see of it since the last update.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "model/curve_order.h"
#include "model/packed_tree.h"
#include "occlude/culler/box.h"
#include "occlude/culler/occluder_mesh.h"
#include "occlude/culler/scene.h"
#include "scene/slots.h"

namespace occlude::culler {

/// Those that stand still and those that move have a tree each. A tree is built anew when one of its occluders has changed.
/// As with SceneObjects, changes touch only what no view sees.
class SceneOccluders {
 public:
  explicit SceneOccluders(SceneNumber& scene) : slots_(scene) {}

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
  [[nodiscard]] bool contains(OccluderId id) const { return slots_.contains(id); }
  [[nodiscard]] std::string fault(OccluderId id) const { return slots_.fault(id); }
  [[nodiscard]] std::size_t size() const { return slots_.size(); }

  /// Returns whether something that stands still hides no longer as it did.
  bool update();

  /// An occluder as views see it.
  struct Standing {
    OccluderId id;
    const OccluderMesh* mesh = nullptr;
    Placement placement;
    std::uint32_t mask = 0;
    ObjectId object;
    bool is_one_sided = false, is_identity = true, is_mirrored = false;
  };
  /// A tree of occluders.
  struct Forest {
    PackedTree tree;
    std::vector<Standing> occluders;  ///< in the order of the tree
  };
  /// Those that stand still, then those that move.
  [[nodiscard]] std::span<const Forest> forests() const { return forests_; }
  /// The box around all; empty_box() if there are none.
  [[nodiscard]] kernel::Aabb box() const;

 private:
  /// What the caller has made of an occluder.
  struct Placed {
    std::shared_ptr<const OccluderMesh> mesh;
    Placement placement;
    OccluderOptions options;
    bool is_enabled = true;
  };

  void changed(const Placed& occluder) { has_changed_[occluder.options.moves ? 1 : 0] = true; }
  /// Also, it may hide less than before.
  void lost(const Placed& occluder) {
    changed(occluder);
    has_lost_ = has_lost_ || !occluder.options.moves;
  }
  void build(std::size_t forest);

  Slots<OccluderId, Placed> slots_;
  std::vector<std::shared_ptr<const OccluderMesh>> retired_;  ///< which views may still see
  std::array<bool, 2> has_changed_{};
  bool has_lost_ = false;

  std::array<Forest, 2> forests_;
  /// The occluders of a forest that is being built, in any order.
  struct BuildMemory {
    std::vector<Standing> occluders;
    std::vector<kernel::Aabb> boxes;
    CurveOrder curve;
  };
  BuildMemory build_memory_;
};

}  // namespace occlude::culler
