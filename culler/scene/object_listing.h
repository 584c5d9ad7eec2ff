// SPDX-License-Identifier: MIT
// Which objects of a frame are drawn, once all is in the coarse picture that hides.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>

#include "camera/view_planes.h"
#include "cover/cover_buffer.h"
#include "cover/hiding_meshes.h"
#include "occlude/culler/scene.h"
#include "occlude/kernel/half_space.h"
#include "scene/thing_group.h"

namespace occlude::culler {

/// By the slots of objects that were found to be hidden, the boxes that were: each holds its object.
using HiddenBoxes = std::unordered_map<std::uint32_t, kernel::Aabb>;

/// Lists objects of some groups. Several listings may be at work at once.
class ObjectListing {
 public:
  /// Lists to `room`, which must be enough for all objects of the groups. What is given outlives this.
  /// Objects are hidden in `hiding`; `own` is the picture of the camera, in which they have a size. `told`, unless it is
  /// null, is told where they are hidden, and `boxes` keeps what was.
  ObjectListing(const SceneOptions& options, const ViewPlanes& view, const CoverBuffer& hiding, const CoverBuffer& own,
                HidingMeshes* told, HiddenBoxes* boxes, std::span<DrawnObject> room)
      : options_(options), view_(view), hiding_(hiding), own_(own), told_(told), boxes_(boxes), room_(room) {}

  /// The objects of a group that are neither hidden nor out of view. `straddled_planes` has a bit for each plane of the view
  /// that may cross the group.
  void list(const ObjectGroup& group, std::uint32_t straddled_planes);
  /// Begins anew.
  void clear() { stats_ = {}; }
  /// Lists an object.
  void draw(const DrawnObject& object) { room_[stats_.drawn++] = object; }
  /// Counts objects that are culled.
  void count(Culled::By by, std::size_t objects) {
    (by == Culled::By::view ? stats_.out_of_view : stats_.hidden) += objects;
  }
  /// Whether the boxes of nodes that are culled so are kept.
  [[nodiscard]] bool keeps(Culled::By by) const { return boxes_ != nullptr && by == Culled::By::cover; }
  /// Keeps the box of a hidden node for each of these objects of a group, which are below it. REQUIRES: keeps().
  void keep(const kernel::Aabb& box, const ObjectGroup& group, const ItemRange& objects) {
    for (std::uint32_t i = objects.first; i < objects.first + objects.count; ++i) {
      if ((group.mask(i) & options_.mask) != 0) boxes_->emplace(group.id(i).slot(), box);
    }
  }
  /// Tells where boxes are hidden.
  void hide(const ProjectedBoxes& boxes, kernel::BoxBits hidden) {
    if (told_ != nullptr) told_->hide(boxes, hidden);
  }

  template <class AnyBox>
  [[nodiscard]] bool is_beyond(std::uint32_t plane, const AnyBox& box) const {
    return kernel::relation(view_.planes[plane], box, view_.arithmetic) == kernel::Relation::outside;
  }
  /// The one of the boxes that hold an object that is beyond the plane, if any.
  [[nodiscard]] std::optional<Box> beyond(std::uint32_t plane, const ObjectGroup& group, std::uint32_t object) const;
  /// As DrawnObject::size.
  [[nodiscard]] float size_of(const kernel::Aabb& box) const;

  [[nodiscard]] std::span<const DrawnObject> drawn() const { return room_.first(stats_.drawn); }
  [[nodiscard]] SceneStats& stats() { return stats_; }

 private:
  class Objects;

  /// The box alone, in the picture of the camera.
  [[nodiscard]] ProjectedBoxes seen(const kernel::Aabb& box) const;

  const SceneOptions& options_;
  const ViewPlanes& view_;
  const CoverBuffer &hiding_, &own_;
  HidingMeshes* told_;
  HiddenBoxes* boxes_;
  std::span<DrawnObject> room_;
  SceneStats stats_;
};

}  // namespace occlude::culler
