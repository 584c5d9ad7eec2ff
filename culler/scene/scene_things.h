// SPDX-License-Identifier: MIT
// The boxes of a scene: those of its objects or those of its occluders. What the caller changes, and what views see of it
// since the last update.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/bounds.h"
#include "model/packed_tree.h"
#include "occlude/culler/executor.h"
#include "occlude/culler/scene.h"
#include "scene/scene_box.h"
#include "scene/slots.h"
#include "scene/thing_group.h"

namespace occlude::culler {

/// Things that stand still are in groups of those that were added together. Each group has a tree of its own, so what comes
/// and goes changes a few groups and not one large tree. Things that move are all in one group, which is built anew when
/// one of them has moved. A tree over the groups changes with them. What is disabled stays where it is, in no layer.
///
/// Changes touch only what no view sees, so they may be made while others cull. update() makes them seen.
template <SceneKind kOf>
class SceneThings {
 public:
  using Id = SceneId<kOf>;
  using Thing = SceneThing<kOf>;
  using Group = ThingGroup<kOf>;

  explicit SceneThings(SceneNumber& scene);

  /// What has no box has no place.
  Id add(const SceneBox& box, const ObjectOptions& options);
  void remove(Id id);
  void remove(std::span<const Id> ids);
  void move(Id id, const SceneBox& box);
  void set_enabled(Id id, bool is_enabled);
  void set_mask(Id id, std::uint32_t mask);
  [[nodiscard]] bool contains(Id id) const { return known_.contains(id); }
  [[nodiscard]] std::string fault(Id id) const { return known_.fault(id); }
  void require(std::span<const Id> ids) const { known_.require(ids); }
  [[nodiscard]] std::size_t size() const { return known_.size(); }

  void update(const Executor& executor);

  /// What views see: a tree whose items are groups.
  [[nodiscard]] const PackedTree& groups() const { return top_; }
  [[nodiscard]] const Group& group(std::uint32_t item) const { return groups_[top_groups_[item]]; }
  /// Whether the group is that of the things that move.
  [[nodiscard]] bool moves(std::uint32_t item) const { return top_groups_[item] == kMoving; }
  /// How many of the things of these items of groups() are in one of these layers.
  [[nodiscard]] std::size_t count(const ItemRange& groups, std::uint32_t mask) const;
  /// Things without a place.
  struct Unplaced {
    Id id;
    std::uint32_t mask = 0;
  };
  [[nodiscard]] std::span<const Unplaced> standing_unplaced() const { return unplaced_; }
  [[nodiscard]] std::span<const Unplaced> moving_unplaced() const { return moving_unplaced_; }
  /// A thing as views see it. None if they do not see it.
  struct Seen {
    std::uint32_t mask;
    const Group* group;   ///< nullptr if it has no place
    std::uint32_t index;  ///< in the group
  };
  [[nodiscard]] std::optional<Seen> seen(Id id) const;
  /// The number of things that views see, those in no layer included.
  [[nodiscard]] std::size_t seen_size() const { return seen_; }
  /// The box around all that have a place; empty_box() if there are none.
  [[nodiscard]] const kernel::Aabb& box() const { return box_; }

  [[nodiscard]] std::size_t bytes() const;

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// What the caller has made of a thing. There is one for each slot, so it is no larger than it must be.
  struct Known {
    static constexpr std::uint32_t kNowhere = (1U << (Id::kSlotBits + 1)) - 1;

    std::uint32_t mask = 0;
    /// Its index in moving_, or in arrivals_ if it has arrived there since the last update.
    std::uint32_t next : Id::kSlotBits + 1 = kNowhere;
    std::uint32_t is_enabled : 1 = 1, moves : 1 = 0, is_always_drawn : 1 = 0;

    void set_next(std::size_t index) { next = index & kNowhere; }
  };
  /// Where views find a thing: in a group, in unplaced_ (kUnplaced) or in moving_unplaced_ (kMovingUnplaced).
  struct Found {
    std::uint32_t group = kNone, index = 0;
  };
  static constexpr std::uint32_t kMoving = 0;  ///< the group of the things that move
  static constexpr std::uint32_t kUnplaced = kNone - 1, kMovingUnplaced = kNone - 2;

  [[nodiscard]] static std::uint32_t seen_mask(const Known& thing) { return thing.is_enabled ? thing.mask : 0; }
  void set_layers(Id id, std::uint32_t mask, bool is_enabled);
  void changed(const Known& thing);
  [[nodiscard]] ThingList<kOf>& list_of(const Known& thing) { return thing.moves ? moving_ : arrivals_; }
  [[nodiscard]] Id seen_id(const Found& at) const;

  void place_again(const Executor& executor);
  void take_arrivals();
  [[nodiscard]] std::size_t placed_of_moving();
  void remove_departed();
  void remove_from_place(std::uint32_t slot);
  void mask_again();
  void place_moving();
  void place_arrivals(const Executor& executor);
  void place_large_batch(const Executor& executor);
  void place_group(const ThingList<kOf>& things);
  void note_places(std::uint32_t group);
  void join_small();
  void tidy_loose();
  void empty_group(std::uint32_t group);
  [[nodiscard]] std::uint32_t free_group(std::size_t things);
  void build_top();
  void count_groups();

  // Of the caller.
  Slots<Id, Known> known_;
  ThingList<kOf> moving_;                ///< all things that move, as they will be
  ThingList<kOf> arrivals_;              ///< things that stand still and were added or moved; one that was removed again
                                         ///< has no id
  std::vector<std::uint32_t> departed_;  ///< slots to be taken out of their places
  std::vector<std::uint32_t> remasked_;  ///< slots whose layers have changed
  std::atomic<bool> has_moved_ = false;  ///< whether the group of what moves is to be built
  bool has_changed_ = false;             ///< whether something that stands still has come, gone or moved

  // Of the views.
  std::vector<Found> places_;  ///< by slots
  std::vector<Group> groups_;
  std::vector<Unplaced> unplaced_, moving_unplaced_;
  PackedTree top_;
  std::vector<std::uint32_t> top_groups_;  ///< the groups in the order of top_
  std::vector<std::uint32_t> before_;      ///< for each group in the order of top_, and the end: things before it, but those
                                           ///< of layered groups
  std::vector<std::uint32_t> layered_;     ///< in the order of top_, groups with a thing that is not in all layers
  std::size_t seen_ = 0;
  kernel::Aabb box_ = empty_box();

  // Of update().
  std::vector<std::uint32_t> free_groups_, small_groups_, loose_groups_;
  ThingList<kOf> batch_;
  std::vector<std::uint32_t> used_groups_;
  GroupBuilder builder_;
  std::vector<kernel::Aabb> boxes_;
};

extern template class SceneThings<SceneKind::object>;
extern template class SceneThings<SceneKind::occluder>;

using SceneObjects = SceneThings<SceneKind::object>;

}  // namespace occlude::culler
