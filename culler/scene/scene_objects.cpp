// SPDX-License-Identifier: MIT
#include "scene/scene_objects.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/parallel.h"
#include "model/bounds.h"
#include "model/outer_box.h"
#include "occlude/culler/scene.h"
#include "scene/scene_box.h"

namespace occlude::culler {
namespace {

/// The most objects of a group of those that stand still. Building one takes a tenth of a millisecond.
constexpr std::uint32_t kMost = 1024;

/// Groups of fewer objects than kSmall are joined when there are kMostSmall of them, which makes one group of at most kMost.
constexpr std::size_t kSmall = 64, kMostSmall = kMost / kSmall;

/// A group of which more than half has been removed is built anew, but only so many in an update. The others wait.
constexpr std::size_t kMostTidied = 4;

/// Memory of this many arrivals is kept for later ones.
constexpr std::size_t kKept = 16 * kMost;

template <class T>
std::size_t bytes_of(const std::vector<T>& v) {
  return v.capacity() * sizeof(T);
}

void require_legal(std::span<const Box> boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const std::string_view reason = fault(boxes[i]);
    if (!reason.empty()) throw std::invalid_argument("object " + std::to_string(i) + ": " + std::string(reason));
  }
}

template <class T>
void forget(std::vector<T>& v) {
  v.clear();
  if (v.capacity() > kKept) v.shrink_to_fit();
}

}  // namespace

SceneObjects::SceneObjects(SceneNumber& scene) : objects_(scene), groups_(1) {}

ObjectId SceneObjects::add(const Box& box, const ObjectOptions& options) { return insert(legal_box(box), options); }

void SceneObjects::add(std::span<const Box> boxes, const ObjectOptions& options, std::span<ObjectId> ids) {
  require_legal(boxes);
  for (std::size_t i = 0; i < boxes.size(); ++i) ids[i] = insert(legal_box(boxes[i]), options);
}

ObjectId SceneObjects::insert(const std::optional<Box>& legal, const ObjectOptions& options) {
  std::vector<Change>& changes = options.moves ? moving_ : arrivals_;
  make_room(changes);
  const Object object{.mask = options.mask,
                      .next = static_cast<std::uint32_t>(changes.size()),
                      .moves = options.moves,
                      .is_always_drawn = options.is_always_drawn};
  const ObjectId id = objects_.add(object);
  changes.push_back({{id, object.mask, legal.value_or(Box{})}, !legal || object.is_always_drawn});
  changed(object);
  return id;
}

void SceneObjects::changed(const Object& object) {
  if (object.moves) {
    has_moved_.store(true, std::memory_order_relaxed);
  } else {
    has_changed_ = true;
  }
}

void SceneObjects::remove(ObjectId id) {
  const Object& object = objects_[id];
  departed_.push_back(id.slot());
  changed(object);
  if (object.moves) {
    // The last one takes its place.
    moving_[object.next] = moving_.back();
    objects_.at(moving_[object.next].object.id.slot()).next = object.next;
    moving_.pop_back();
  } else if (object.next != kNone) {
    arrivals_[object.next].object.id = {};
  }
  objects_.remove(id);
}

void SceneObjects::remove(std::span<const ObjectId> ids) {
  require(ids);
  for (const ObjectId id : ids) {
    if (contains(id)) remove(id);  // not so the second time
  }
}

void SceneObjects::move(ObjectId id, const Box& box) {
  const std::optional<Box> legal = legal_box(box);
  Object& object = objects_[id];
  if (!object.moves && object.next == kNone) {
    arrivals_.push_back({{id, seen_mask(object), {}}, false});
    object.next = static_cast<std::uint32_t>(arrivals_.size() - 1);
  }
  Change& change = (object.moves ? moving_ : arrivals_)[object.next];
  change.object.box = legal.value_or(Box{});
  change.is_unplaced = !legal || object.is_always_drawn;
  changed(object);
}

void SceneObjects::move(std::span<const ObjectId> ids, std::span<const Box> boxes) {
  require(ids);
  require_legal(boxes);
  for (std::size_t i = 0; i < ids.size(); ++i) move(ids[i], boxes[i]);
}

void SceneObjects::set_enabled(ObjectId id, bool is_enabled) { set_layers(id, objects_[id].mask, is_enabled); }

void SceneObjects::set_mask(ObjectId id, std::uint32_t mask) { set_layers(id, mask, objects_[id].is_enabled); }

void SceneObjects::set_layers(ObjectId id, std::uint32_t mask, bool is_enabled) {
  remasked_.push_back(id.slot());
  Object& object = objects_[id];
  object.mask = mask;
  object.is_enabled = is_enabled;
  if (object.next != kNone) (object.moves ? moving_ : arrivals_)[object.next].object.mask = seen_mask(object);
  changed(object);
}

void SceneObjects::update(const Executor& executor) {
  if (!has_changed_ && !has_moved_) return;
  places_.resize(objects_.slots());
  remove_departed();
  mask_again();
  if (has_moved_) place_moving();
  place_arrivals(executor);
  tidy_loose();
  if (small_groups_.size() >= kMostSmall) join_small();
  build_top();
  has_changed_ = false;
  has_moved_ = false;
}

void SceneObjects::remove_departed() {
  for (const std::uint32_t slot : departed_) remove_from_place(slot);
  departed_.clear();
}

void SceneObjects::remove_from_place(std::uint32_t slot) {
  Place& place = places_[slot];
  if (place.group == kUnplaced) {
    unplaced_[place.index] = unplaced_.back();
    places_[unplaced_[place.index].id.slot()].index = place.index;
    unplaced_.pop_back();
  } else if (place.group < kMovingUnplaced && place.group != kMoving) {
    ObjectGroup& group = groups_[place.group];
    const std::size_t half = group.size() / 2;
    const bool was_half = group.living() > half;
    group.remove(place.index);
    if (was_half && group.living() <= half) loose_groups_.push_back(place.group);
  }
  place = {};
}

void SceneObjects::mask_again() {
  for (const std::uint32_t slot : remasked_) {
    const Place& place = places_[slot];
    if (place.group == kUnplaced) {
      unplaced_[place.index].mask = seen_mask(objects_.at(slot));
    } else if (place.group < kMovingUnplaced) {
      groups_[place.group].set_mask(place.index, seen_mask(objects_.at(slot)));
    }
  }
  remasked_.clear();
}

void SceneObjects::place_moving() {
  moving_unplaced_.clear();
  batch_.clear();
  for (const Change& change : moving_) {
    if (change.is_unplaced) {
      const auto index = static_cast<std::uint32_t>(moving_unplaced_.size());
      places_[change.object.id.slot()] = {change.object.id.generation(), kMovingUnplaced, index};
      moving_unplaced_.push_back({change.object.id, change.object.mask});
    } else {
      batch_.push_back(change.object);
    }
  }
  ObjectGroup& group = groups_[kMoving];
  group.assign(batch_, false, builder_);
  for (std::uint32_t i = 0; i < group.size(); ++i) places_[group.id(i).slot()] = {group.id(i).generation(), kMoving, i};
}

/// Puts what was added or moved into groups of objects that are near each other.
void SceneObjects::place_arrivals(const Executor& executor) {
  batch_.clear();
  for (const auto& [object, is_unplaced] : arrivals_) {
    if (object.id.is_none()) continue;
    objects_.at(object.id.slot()).next = kNone;
    remove_from_place(object.id.slot());
    if (!is_unplaced) {
      batch_.push_back(object);
      continue;
    }
    places_[object.id.slot()] = {object.id.generation(), kUnplaced, static_cast<std::uint32_t>(unplaced_.size())};
    unplaced_.push_back({object.id, object.mask});
  }
  forget(arrivals_);
  if (batch_.size() <= kMost) {
    place_group(batch_);
  } else {
    place_large_batch(executor);
  }
  forget(batch_);
}

/// Divides the batch into groups of objects that are near each other. They are built in parts, by the executor.
void SceneObjects::place_large_batch(const Executor& executor) {
  std::vector<kernel::Aabb> boxes;
  for (const SceneObject& object : batch_) boxes.push_back(outer_box(object.box));
  CurveOrder curve;
  curve.sort(boxes);
  struct Chunk {
    std::span<const std::uint32_t> objects;
    std::uint32_t group;
  };
  std::vector<Chunk> work;
  for (const auto& [first, count] : curve.runs(kMost)) {
    work.push_back({curve.order().subspan(first, count), free_group(count)});
  }
  const std::size_t parts = executor.threads(), length = (work.size() + parts - 1) / parts;
  const auto build_part = [&](std::size_t part) {
    GroupBuilder builder;
    std::vector<SceneObject> objects;
    for (std::size_t i = part * length; i < std::min((part + 1) * length, work.size()); ++i) {
      objects.clear();
      for (const std::uint32_t k : work[i].objects) objects.push_back(batch_[k]);
      groups_[work[i].group].assign(objects, true, builder);
    }
  };
  parallel_for(parts, build_part, Checkpoint(executor));
  for (const Chunk& chunk : work) note_places(chunk.group);
}

void SceneObjects::place_group(std::span<const SceneObject> objects) {
  if (objects.empty()) return;
  const std::uint32_t number = free_group(objects.size());
  groups_[number].assign(objects, true, builder_);
  note_places(number);
}

void SceneObjects::note_places(std::uint32_t number) {
  const ObjectGroup& group = groups_[number];
  for (std::uint32_t i = 0; i < group.size(); ++i) places_[group.id(i).slot()] = {group.id(i).generation(), number, i};
  if (group.size() < kSmall) small_groups_.push_back(number);
}

/// An unused group, if possible the smallest that has room for so many objects.
std::uint32_t SceneObjects::free_group(std::size_t objects) {
  const auto room = [&](std::uint32_t group) {
    const std::size_t capacity = groups_[group].capacity();
    return capacity < objects ? std::numeric_limits<std::size_t>::max() : capacity;
  };
  const auto best = std::ranges::min_element(free_groups_, {}, room);
  if (best == free_groups_.end()) {
    groups_.emplace_back();
    return static_cast<std::uint32_t>(groups_.size() - 1);
  }
  const std::uint32_t group = *best;
  free_groups_.erase(best);
  return group;
}

void SceneObjects::empty_group(std::uint32_t group) {
  groups_[group].clear();
  free_groups_.push_back(group);
}

/// Makes one group of all small ones.
void SceneObjects::join_small() {
  batch_.clear();
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
void SceneObjects::tidy_loose() {
  for (std::size_t tidied = 0; tidied < kMostTidied && !loose_groups_.empty();) {
    const std::uint32_t group = loose_groups_.back();
    loose_groups_.pop_back();
    if (groups_[group].size() == 0) continue;  // emptied since
    batch_.clear();
    groups_[group].append_living(batch_);
    empty_group(group);
    if (batch_.empty()) continue;
    place_group(batch_);
    ++tidied;
  }
}

void SceneObjects::build_top() {
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
  builder_.curve.sort(boxes_);
  top_.build(boxes_, builder_.curve.order());
  top_groups_.clear();
  for (const std::uint32_t k : builder_.curve.order()) top_groups_.push_back(used_groups_[k]);
  count_groups();
}

void SceneObjects::count_groups() {
  before_.clear();
  layered_.clear();
  std::uint32_t objects = 0;
  for (std::uint32_t i = 0; i < top_groups_.size(); ++i) {
    before_.push_back(objects);
    const ObjectGroup& group = this->group(i);
    if (group.is_in_all_layers()) {
      objects += static_cast<std::uint32_t>(group.living());
    } else {
      layered_.push_back(i);
    }
  }
  before_.push_back(objects);
}

std::size_t SceneObjects::count(const ItemRange& groups, std::uint32_t mask) const {
  const std::uint32_t end = groups.first + groups.count;
  std::size_t objects = mask == 0 ? 0 : before_[end] - before_[groups.first];
  for (auto i = std::ranges::lower_bound(layered_, groups.first); i != layered_.end() && *i < end; ++i) {
    objects += group(*i).count(mask);
  }
  return objects;
}

std::optional<SceneObjects::Seen> SceneObjects::seen(ObjectId id) const {
  if (id.slot() >= places_.size()) return std::nullopt;
  const Place& place = places_[id.slot()];
  if (place.group == kNone || place.generation != id.generation()) return std::nullopt;
  if (place.group == kUnplaced) return Seen{unplaced_[place.index].mask, nullptr, 0};
  if (place.group == kMovingUnplaced) return Seen{moving_unplaced_[place.index].mask, nullptr, 0};
  const ObjectGroup& group = groups_[place.group];
  return Seen{group.mask(place.index), &group, place.index};
}

std::size_t SceneObjects::bytes() const {
  std::size_t bytes = objects_.bytes() + bytes_of(moving_) + bytes_of(arrivals_) + bytes_of(departed_) +
                      bytes_of(remasked_) + bytes_of(places_) + bytes_of(groups_) + bytes_of(unplaced_) +
                      bytes_of(moving_unplaced_) + bytes_of(top_groups_) + bytes_of(used_groups_) + top_.bytes() +
                      bytes_of(before_) + bytes_of(layered_) + bytes_of(free_groups_) + bytes_of(small_groups_) +
                      bytes_of(loose_groups_) + bytes_of(batch_) + builder_.curve.bytes() + builder_.split.bytes() +
                      bytes_of(builder_.boxes) + bytes_of(boxes_);
  for (const ObjectGroup& group : groups_) bytes += group.bytes();
  return bytes;
}

}  // namespace occlude::culler
