// SPDX-License-Identifier: MIT
// Some things of a scene, with a tree of their own.
#pragma once

#include <hwy/cache_control.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "model/curve_order.h"
#include "model/packed_tree.h"
#include "model/split_order.h"
#include "occlude/culler/scene.h"
#include "occlude/kernel/box_block.h"
#include "occlude/kernel/types.h"
#include "scene/packed_edges.h"
#include "scene/slots.h"

namespace occlude::culler {

/// An object or an occluder, beside its SceneBox::outer.
template <SceneKind kOf>
struct SceneThing {
  SceneId<kOf> id;
  std::uint32_t mask = 0;  ///< 0 if it is disabled
  PackedEdges edges;
};

/// Things and where they are, side by side, because trees are built of boxes alone.
template <SceneKind kOf>
struct ThingList {
  using Thing = SceneThing<kOf>;

  std::vector<kernel::Aabb> boxes;  ///< SceneBox::outer
  std::vector<Thing> things;

  [[nodiscard]] std::size_t size() const { return things.size(); }
  /// The bytes of memory that it holds.
  [[nodiscard]] std::size_t bytes() const {
    return boxes.capacity() * sizeof(kernel::Aabb) + things.capacity() * sizeof(Thing);
  }
  /// So that adding one more cannot fail.
  void make_room() {
    constexpr std::size_t kShare = 4;
    culler::make_room(boxes, kShare);
    culler::make_room(things, kShare);
  }
  void push_back(const kernel::Aabb& box, const Thing& thing) {
    boxes.push_back(box);
    things.push_back(thing);
  }
  void resize(std::size_t size) {
    boxes.resize(size);
    things.resize(size);
  }
  void swap(std::size_t i, std::size_t k) {
    std::swap(boxes[i], boxes[k]);
    std::swap(things[i], things[k]);
  }
  void copy(std::size_t from, std::size_t to) {
    boxes[to] = boxes[from];
    things[to] = things[from];
  }
};

/// Memory for building, shared by all groups.
struct GroupBuilder {
  CurveOrder curve;
  SplitOrder split;

  /// The indices of the boxes in an order for a tree. `is_lasting` says that the tree is for many frames, and so worth a
  /// better order.
  std::span<const std::uint32_t> sort(std::span<const kernel::Aabb> boxes, bool is_lasting);
};

/// Several threads may read at once.
template <SceneKind kOf>
class ThingGroup {
 public:
  using Id = SceneId<kOf>;
  using Thing = SceneThing<kOf>;

  /// `is_lasting`: as GroupBuilder::sort(). REQUIRES: as many things as boxes, and each is_some().
  void assign(std::span<const kernel::Aabb> boxes, std::span<const Thing> things, bool is_lasting, GroupBuilder& builder);
  void clear();
  /// Removes thing i. Its place stays empty, and in no layer. The tree stays, so its boxes may be larger than they need be.
  void remove(std::uint32_t i);
  /// Makes box() that of what is left.
  void fit_box();
  void set_mask(std::uint32_t i, std::uint32_t mask);
  /// Appends what is left.
  void append_living(ThingList<kOf>& things) const;

  /// The places of things, in the order of the tree; of these, those that are not empty.
  [[nodiscard]] std::size_t size() const { return ids_.size(); }
  [[nodiscard]] std::size_t living() const { return living_; }
  /// The box around all things, those removed since the last fit_box() included.
  [[nodiscard]] const kernel::Aabb& box() const { return box_; }
  /// How many things have room without allocating.
  [[nodiscard]] std::size_t capacity() const { return ids_.capacity(); }
  [[nodiscard]] std::size_t bytes() const;

  /// A tree over outer(i), those of empty places included.
  [[nodiscard]] const PackedTree& tree() const { return tree_; }
  /// None if the place is empty.
  [[nodiscard]] Id id(std::uint32_t i) const { return ids_[i]; }
  /// 0 if the place is empty.
  [[nodiscard]] std::uint32_t mask(std::uint32_t i) const { return masks_[i]; }
  /// Of the things [first, first + 8): those that are in one of these layers, and those whose boxes are oriented.
  struct Kinds {
    kernel::BoxBits in_layers = 0, oriented = 0;
  };
  [[nodiscard]] Kinds kinds(std::uint32_t first, std::uint32_t mask) const;
  /// A hint that kinds(first, …) comes.
  void prefetch(std::uint32_t first) const {
    hwy::Prefetch(&masks_[first]);
    hwy::Prefetch(&ids_[first]);
  }
  /// Holds thing i, as oriented(i) does.
  [[nodiscard]] kernel::Aabb outer(std::uint32_t i) const { return tree_.item(i); }
  [[nodiscard]] std::optional<kernel::Obb> oriented(std::uint32_t i) const {
    if (!is_oriented(i)) return std::nullopt;
    return edges_[i].box(outer(i));
  }
  /// Whether every thing is in all layers.
  [[nodiscard]] bool is_in_all_layers() const { return is_in_all_layers_; }
  /// How many of these things are in one of these layers.
  [[nodiscard]] std::size_t count(const ItemRange& things, std::uint32_t mask) const {
    return is_whole(mask) ? things.count : count_one_by_one(things, mask);
  }
  [[nodiscard]] std::size_t count(std::uint32_t mask) const { return count({0, static_cast<std::uint32_t>(size())}, mask); }

 private:
  /// Whether no place is empty, and every thing is in one of these layers.
  [[nodiscard]] bool is_whole(std::uint32_t mask) const { return is_in_all_layers_ && living_ == size() && mask != 0; }
  [[nodiscard]] std::size_t count_one_by_one(const ItemRange& things, std::uint32_t mask) const;

  [[nodiscard]] bool is_oriented(std::size_t i) const { return !edges_.empty() && !edges_[i].is_none(); }

  PackedTree tree_;
  std::vector<Id> ids_;
  std::vector<std::uint32_t> masks_;
  std::vector<PackedEdges> edges_;  ///< none at all if no box is oriented
  std::size_t living_ = 0;
  kernel::Aabb box_;
  bool is_box_loose_ = false;
  bool is_in_all_layers_ = true;
};

extern template class ThingGroup<SceneKind::object>;
extern template class ThingGroup<SceneKind::occluder>;

using ObjectGroup = ThingGroup<SceneKind::object>;
using OccluderGroup = ThingGroup<SceneKind::occluder>;

}  // namespace occlude::culler
