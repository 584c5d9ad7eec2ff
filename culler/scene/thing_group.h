// SPDX-License-Identifier: MIT
// Some things of a scene, with a tree of their own.
#pragma once

#include <hwy/cache_control.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "model/curve_order.h"
#include "model/packed_tree.h"
#include "model/split_order.h"
#include "occlude/culler/box.h"
#include "occlude/culler/scene.h"
#include "occlude/kernel/box_block.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// An object or an occluder, and where it is.
template <SceneKind kOf>
struct SceneThing {
  SceneId<kOf> id;
  std::uint32_t mask = 0;  ///< 0 if it is disabled
  Box box;                 ///< legal, and so is its outer_box()
};

/// Memory for building, shared by all groups.
struct GroupBuilder {
  CurveOrder curve;
  SplitOrder split;
  std::vector<kernel::Aabb> boxes;

  /// The indices of `boxes` in an order for a tree.
  std::span<const std::uint32_t> sort(bool is_lasting);
};

/// Several threads may read at once.
template <SceneKind kOf>
class ThingGroup {
 public:
  using Id = SceneId<kOf>;
  using Thing = SceneThing<kOf>;

  /// `is_lasting` says that the tree is for many frames, and so worth a better order.
  void assign(std::span<const Thing> things, bool is_lasting, GroupBuilder& builder);
  void clear();
  /// Removes thing i. Its place stays empty, and in no layer. The tree stays, so its boxes may be larger than they need be.
  void remove(std::uint32_t i);
  /// Makes box() that of what is left.
  void fit_box();
  void set_mask(std::uint32_t i, std::uint32_t mask);
  /// Appends what is left.
  void append_living(std::vector<Thing>& things) const;

  /// The places of things, in the order of the tree; of these, those that are not empty.
  [[nodiscard]] std::size_t size() const { return places_.size(); }
  [[nodiscard]] std::size_t living() const { return living_; }
  /// The box around all things, those removed since the last fit_box() included.
  [[nodiscard]] const kernel::Aabb& box() const { return box_; }
  /// How many things have room without allocating.
  [[nodiscard]] std::size_t capacity() const { return places_.capacity(); }
  [[nodiscard]] std::size_t bytes() const;

  /// A tree over outer(i), those of empty places included.
  [[nodiscard]] const PackedTree& tree() const { return tree_; }
  [[nodiscard]] Id id(std::uint32_t i) const { return places_[i].id; }
  [[nodiscard]] std::uint32_t mask(std::uint32_t i) const { return places_[i].mask; }
  /// Of the things [first, first + 8): those that are in one of these layers, and those whose boxes are oriented.
  struct Kinds {
    kernel::BoxBits in_layers = 0, oriented = 0;
  };
  [[nodiscard]] Kinds kinds(std::uint32_t first, std::uint32_t mask) const;
  /// A hint that kinds(first, …) comes.
  void prefetch(std::uint32_t first) const {
    hwy::Prefetch(&places_[first]);
    hwy::Prefetch(&places_[std::min<std::size_t>(first + TreeBlock::kNodes, size()) - 1]);
  }
  [[nodiscard]] kernel::Aabb outer(std::uint32_t i) const { return tree_.item(i); }
  /// Calls question(box) with the box of thing i, which may be oriented.
  template <class Question>
  decltype(auto) ask(std::uint32_t i, const Question& question) const {
    const std::uint32_t k = places_[i].oriented;
    return k == kNone ? question(outer(i)) : question(oriented_[k]);
  }
  /// Whether every thing is in all layers.
  [[nodiscard]] bool is_in_all_layers() const { return is_in_all_layers_; }
  /// How many of these things are in one of these layers.
  [[nodiscard]] std::size_t count(const ItemRange& things, std::uint32_t mask) const {
    return is_whole(mask) ? things.count : count_one_by_one(things, mask);
  }
  [[nodiscard]] std::size_t count(std::uint32_t mask) const { return count({0, static_cast<std::uint32_t>(size())}, mask); }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// Whether no place is empty, and every thing is in one of these layers.
  [[nodiscard]] bool is_whole(std::uint32_t mask) const { return is_in_all_layers_ && living_ == size() && mask != 0; }
  [[nodiscard]] std::size_t count_one_by_one(const ItemRange& things, std::uint32_t mask) const;

  struct Place {
    Id id;                   ///< none if the place is empty
    std::uint32_t mask;      ///< 0 if the place is empty
    std::uint32_t oriented;  ///< the index in oriented_, or kNone
  };

  PackedTree tree_;
  std::vector<Place> places_;
  std::vector<kernel::Obb> oriented_;
  std::size_t living_ = 0;
  kernel::Aabb box_;
  bool is_box_loose_ = false;
  bool is_in_all_layers_ = true;
};

extern template class ThingGroup<SceneKind::object>;
extern template class ThingGroup<SceneKind::occluder>;

using SceneObject = SceneThing<SceneKind::object>;
using ObjectGroup = ThingGroup<SceneKind::object>;
using OccluderGroup = ThingGroup<SceneKind::occluder>;

}  // namespace occlude::culler
