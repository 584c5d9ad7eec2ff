// SPDX-License-Identifier: MIT
#include "scene/scene_things.h"

#include <algorithm>

#include "base/parallel.h"
#include "model/bounds.h"
#include "occlude/culler/scene.h"

namespace occlude::culler {
namespace {

/// The most things of a group of those that stand still. Building one takes a tenth of a millisecond.
constexpr std::uint32_t kMost = 1024;

/// Groups of fewer things than kSmall are joined when there are kMostSmall of them, which makes one group of at most kMost.
constexpr std::size_t kSmall = 64, kMostSmall = kMost / kSmall;

/// A group of which more than half has been removed is built anew, but only so many in an update. The others wait.
constexpr std::size_t kMostTidied = 4;

template <class T>
std::size_t bytes_of(const std::vector<T>& v) {
  return v.capacity() * sizeof(T);
}

}  // namespace

template <SceneKind kOf>
SceneThings<kOf>::SceneThings(SceneNumber& scene) : known_(scene), groups_(1) {}

template <SceneKind kOf>
typename SceneThings<kOf>::Id SceneThings<kOf>::add(const SceneBox& box, const ObjectOptions& options) {
  ThingList<kOf>& list = options.moves ? moving_ : arrivals_;
  list.make_room();
  Known thing{.mask = options.mask, .moves = options.moves, .is_always_drawn = options.is_always_drawn};
  thing.set_next(list.size());
  const Id id = known_.add(thing);
  list.push_back(thing.is_always_drawn ? empty_box() : box.outer, {id, thing.mask, box.edges});
  changed(thing);
  return id;
}

template <SceneKind kOf>
void SceneThings<kOf>::changed(const Known& thing) {
  if (thing.moves) {
    has_moved_.store(true, std::memory_order_relaxed);
  } else {
    has_changed_ = true;
  }
}

template <SceneKind kOf>
void SceneThings<kOf>::remove(Id id) {
  const Known& thing = known_[id];
  departed_.push_back(id.slot());
  changed(thing);
  if (thing.moves) {
    // The last one takes its place.
    moving_.copy(moving_.size() - 1, thing.next);
    known_.at(moving_.things[thing.next].id.slot()).next = thing.next;
    moving_.resize(moving_.size() - 1);
  } else if (thing.next != Known::kNowhere) {
    arrivals_.things[thing.next].id = {};
  }
  known_.remove(id);
}

template <SceneKind kOf>
void SceneThings<kOf>::remove(std::span<const Id> ids) {
  require(ids);
  for (const Id id : ids) {
    if (contains(id)) remove(id);  // not so the second time
  }
}

template <SceneKind kOf>
void SceneThings<kOf>::move(Id id, const SceneBox& box) {
  Known& thing = known_[id];
  if (!thing.moves && thing.next == Known::kNowhere) {
    arrivals_.push_back({}, {id, seen_mask(thing), {}});
    thing.set_next(arrivals_.size() - 1);
  }
  ThingList<kOf>& list = list_of(thing);
  list.boxes[thing.next] = thing.is_always_drawn ? empty_box() : box.outer;
  list.things[thing.next].edges = box.edges;
  changed(thing);
}

template <SceneKind kOf>
void SceneThings<kOf>::set_enabled(Id id, bool is_enabled) {
  set_layers(id, known_[id].mask, is_enabled);
}

template <SceneKind kOf>
void SceneThings<kOf>::set_mask(Id id, std::uint32_t mask) {
  set_layers(id, mask, known_[id].is_enabled);
}

template <SceneKind kOf>
void SceneThings<kOf>::set_layers(Id id, std::uint32_t mask, bool is_enabled) {
  remasked_.push_back(id.slot());
  Known& thing = known_[id];
  thing.mask = mask;
  thing.is_enabled = is_enabled;
  if (thing.next != Known::kNowhere) list_of(thing).things[thing.next].mask = seen_mask(thing);
}

template <SceneKind kOf>
void SceneThings<kOf>::update(const Executor& executor) {
  if (!has_changed_ && !has_moved_ && remasked_.empty()) return;
  places_.reserve(known_.capacity());
  places_.resize(known_.slots());
  remove_departed();
  mask_again();
  if (has_changed_ || has_moved_) place_again(executor);
  count_groups();
}

template <SceneKind kOf>
void SceneThings<kOf>::place_again(const Executor& executor) {
  if (has_moved_) place_moving();
  take_arrivals();
  tidy_loose();
  place_arrivals(executor);
  if (small_groups_.size() >= kMostSmall) join_small();
  build_top();
  has_changed_ = false;
  has_moved_ = false;
}

template <SceneKind kOf>
void SceneThings<kOf>::remove_departed() {
  for (const std::uint32_t slot : departed_) remove_from_place(slot);
  departed_.clear();
}

template <SceneKind kOf>
void SceneThings<kOf>::remove_from_place(std::uint32_t slot) {
  Found& at = places_[slot];
  if (at.group == kUnplaced) {
    unplaced_[at.index] = unplaced_.back();
    places_[unplaced_[at.index].id.slot()].index = at.index;
    unplaced_.pop_back();
  } else if (at.group < kMovingUnplaced && at.group != kMoving) {
    Group& group = groups_[at.group];
    const std::size_t half = group.size() / 2;
    const bool was_half = group.living() > half;
    group.remove(at.index);
    if (was_half && group.living() <= half) loose_groups_.push_back(at.group);
  }
  at = {};
}

template <SceneKind kOf>
void SceneThings<kOf>::mask_again() {
  for (const std::uint32_t slot : remasked_) {
    const Found& at = places_[slot];
    if (at.group == kNone) continue;
    const std::uint32_t mask = seen_mask(known_.at(slot));
    if (at.group == kUnplaced) {
      unplaced_[at.index].mask = mask;
    } else if (at.group == kMovingUnplaced) {
      moving_unplaced_[at.index].mask = mask;
    } else {
      groups_[at.group].set_mask(at.index, mask);
    }
  }
  remasked_.clear();
}

template <SceneKind kOf>
void SceneThings<kOf>::place_moving() {
  const std::size_t placed = placed_of_moving();
  moving_unplaced_.clear();
  for (const Thing& thing : std::span(moving_.things).subspan(placed)) {
    places_[thing.id.slot()] = {kMovingUnplaced, static_cast<std::uint32_t>(moving_unplaced_.size())};
    moving_unplaced_.push_back({thing.id, thing.mask});
  }
  Group& group = groups_[kMoving];
  group.assign(std::span(moving_.boxes).first(placed), std::span(moving_.things).first(placed), false, builder_);
  for (std::uint32_t i = 0; i < group.size(); ++i) places_[group.id(i).slot()] = {kMoving, i};
}

/// Puts the things of moving_ that have a place before the others. Returns how many they are.
template <SceneKind kOf>
std::size_t SceneThings<kOf>::placed_of_moving() {
  std::uint32_t placed = 0;
  for (std::uint32_t i = 0; i < moving_.size(); ++i) {
    if (!is_some(moving_.boxes[i])) continue;
    if (i != placed) {
      moving_.swap(i, placed);
      known_.at(moving_.things[i].id.slot()).set_next(i);
      known_.at(moving_.things[placed].id.slot()).set_next(placed);
    }
    ++placed;
  }
  return placed;
}

/// Takes what was added or moved out of its old place. What has a new place is left in arrivals_.
template <SceneKind kOf>
void SceneThings<kOf>::take_arrivals() {
  std::size_t placed = 0;
  for (std::size_t i = 0; i < arrivals_.size(); ++i) {
    const Thing& thing = arrivals_.things[i];
    if (thing.id.is_none()) continue;
    known_.at(thing.id.slot()).next = Known::kNowhere;
    remove_from_place(thing.id.slot());
    if (is_some(arrivals_.boxes[i])) {
      arrivals_.copy(i, placed++);
    } else {
      places_[thing.id.slot()] = {kUnplaced, static_cast<std::uint32_t>(unplaced_.size())};
      unplaced_.push_back({thing.id, thing.mask});
    }
  }
  arrivals_.resize(placed);
}

/// Puts what has arrived into groups of things that are near each other.
template <SceneKind kOf>
void SceneThings<kOf>::place_arrivals(const Executor& executor) {
  if (arrivals_.size() <= kMost) {
    place_group(arrivals_);
    arrivals_.resize(0);
  } else {
    place_large_batch(executor);
    arrivals_ = {};
  }
}

/// Divides what has arrived into groups of things that are near each other. They are built in parts, by the executor.
template <SceneKind kOf>
void SceneThings<kOf>::place_large_batch(const Executor& executor) {
  CurveOrder curve;
  curve.sort(arrivals_.boxes);
  struct Chunk {
    std::span<const std::uint32_t> things;
    std::uint32_t group;
  };
  std::vector<Chunk> work;
  for (const auto& [first, count] : curve.runs(kMost)) {
    work.push_back({curve.order().subspan(first, count), free_group(count)});
  }
  const std::size_t parts = executor.threads(), length = (work.size() + parts - 1) / parts;
  const auto build_part = [&](std::size_t part) {
    GroupBuilder builder;
    ThingList<kOf> of_group;
    for (std::size_t i = part * length; i < std::min((part + 1) * length, work.size()); ++i) {
      of_group.resize(0);
      for (const std::uint32_t k : work[i].things) of_group.push_back(arrivals_.boxes[k], arrivals_.things[k]);
      groups_[work[i].group].assign(of_group.boxes, of_group.things, true, builder);
    }
  };
  parallel_for(parts, build_part, Checkpoint(executor));
  for (const Chunk& chunk : work) note_places(chunk.group);
}

template <SceneKind kOf>
void SceneThings<kOf>::place_group(const ThingList<kOf>& things) {
  if (things.size() == 0) return;
  const std::uint32_t number = free_group(things.size());
  groups_[number].assign(things.boxes, things.things, true, builder_);
  note_places(number);
}

template <SceneKind kOf>
void SceneThings<kOf>::note_places(std::uint32_t number) {
  const Group& group = groups_[number];
  for (std::uint32_t i = 0; i < group.size(); ++i) places_[group.id(i).slot()] = {number, i};
  if (group.size() < kSmall) small_groups_.push_back(number);
}

/// An unused group, if possible the smallest that has room for so many things.
template <SceneKind kOf>
std::uint32_t SceneThings<kOf>::free_group(std::size_t things) {
  const auto room = [&](std::uint32_t group) {
    const std::size_t capacity = groups_[group].capacity();
    return capacity < things ? std::numeric_limits<std::size_t>::max() : capacity;
  };
  const auto best = std::ranges::min_element(free_groups_, {}, room);
  if (best == free_groups_.end()) {
    make_room(groups_, kShareOfLasting);
    groups_.emplace_back();
    return static_cast<std::uint32_t>(groups_.size() - 1);
  }
  const std::uint32_t group = *best;
  free_groups_.erase(best);
  return group;
}

template <SceneKind kOf>
void SceneThings<kOf>::empty_group(std::uint32_t group) {
  groups_[group].clear();
  free_groups_.push_back(group);
}

/// Makes one group of all small ones.
template <SceneKind kOf>
void SceneThings<kOf>::join_small() {
  batch_.resize(0);
  for (const std::uint32_t group : small_groups_) {
    const std::size_t size = groups_[group].size();
    if (size == 0 || size >= kSmall) continue;  // emptied since, or listed twice; it may be a large one by now
    groups_[group].append_living(batch_);
    empty_group(group);
  }
  small_groups_.clear();
  place_group(batch_);
}

/// Builds groups without their empty places.
template <SceneKind kOf>
void SceneThings<kOf>::tidy_loose() {
  for (std::size_t tidied = 0; tidied < kMostTidied && !loose_groups_.empty();) {
    const std::uint32_t group = loose_groups_.back();
    loose_groups_.pop_back();
    if (groups_[group].size() == 0) continue;  // emptied since
    batch_.resize(0);
    groups_[group].append_living(batch_);
    empty_group(group);
    if (batch_.size() == 0) continue;
    place_group(batch_);
    ++tidied;
  }
}

template <SceneKind kOf>
void SceneThings<kOf>::build_top() {
  used_groups_.clear();
  boxes_.clear();
  seen_ = unplaced_.size() + moving_unplaced_.size();
  box_ = empty_box();
  for (std::uint32_t g = 0; g < groups_.size(); ++g) {
    if (groups_[g].living() == 0) continue;
    seen_ += groups_[g].living();
    groups_[g].fit_box();
    grow(box_, groups_[g].box());
    used_groups_.push_back(g);
    boxes_.push_back(groups_[g].tree().box());
  }
  const std::span<const std::uint32_t> order = builder_.sort(boxes_, false);
  top_.build(boxes_, order);
  top_groups_.clear();
  for (const std::uint32_t k : order) top_groups_.push_back(used_groups_[k]);
}

template <SceneKind kOf>
void SceneThings<kOf>::count_groups() {
  before_.clear();
  layered_.clear();
  std::uint32_t things = 0;
  for (std::uint32_t i = 0; i < top_groups_.size(); ++i) {
    before_.push_back(things);
    const Group& group = this->group(i);
    if (group.is_in_all_layers()) {
      things += static_cast<std::uint32_t>(group.living());
    } else {
      layered_.push_back(i);
    }
  }
  before_.push_back(things);
}

template <SceneKind kOf>
std::size_t SceneThings<kOf>::count(const ItemRange& groups, std::uint32_t mask) const {
  const std::uint32_t end = groups.first + groups.count;
  std::size_t things = mask == 0 ? 0 : before_[end] - before_[groups.first];
  for (auto i = std::ranges::lower_bound(layered_, groups.first); i != layered_.end() && *i < end; ++i) {
    things += group(*i).count(mask);
  }
  return things;
}

/// REQUIRES: there is such a thing.
template <SceneKind kOf>
typename SceneThings<kOf>::Id SceneThings<kOf>::seen_id(const Found& at) const {
  if (at.group == kUnplaced) return unplaced_[at.index].id;
  if (at.group == kMovingUnplaced) return moving_unplaced_[at.index].id;
  return groups_[at.group].id(at.index);
}

template <SceneKind kOf>
std::optional<typename SceneThings<kOf>::Seen> SceneThings<kOf>::seen(Id id) const {
  if (id.slot() >= places_.size()) return std::nullopt;
  const Found& at = places_[id.slot()];
  if (at.group == kNone || seen_id(at) != id) return std::nullopt;
  if (at.group == kUnplaced) return Seen{unplaced_[at.index].mask, nullptr, 0};
  if (at.group == kMovingUnplaced) return Seen{moving_unplaced_[at.index].mask, nullptr, 0};
  const Group& group = groups_[at.group];
  return Seen{group.mask(at.index), &group, at.index};
}

template <SceneKind kOf>
std::size_t SceneThings<kOf>::bytes() const {
  std::size_t bytes = known_.bytes() + moving_.bytes() + arrivals_.bytes() + bytes_of(departed_) + bytes_of(remasked_) +
                      bytes_of(places_) + bytes_of(groups_) + bytes_of(unplaced_) + bytes_of(moving_unplaced_) +
                      bytes_of(top_groups_) + bytes_of(used_groups_) + top_.bytes() + bytes_of(before_) +
                      bytes_of(layered_) + bytes_of(free_groups_) + bytes_of(small_groups_) + bytes_of(loose_groups_) +
                      batch_.bytes() + builder_.curve.bytes() + builder_.split.bytes() + bytes_of(boxes_);
  for (const Group& group : groups_) bytes += group.bytes();
  return bytes;
}

template class SceneThings<SceneKind::object>;
template class SceneThings<SceneKind::occluder>;

}  // namespace occlude::culler
