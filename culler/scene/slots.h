// SPDX-License-Identifier: MIT
// Things of a caller by ids that are never used twice.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "occlude/culler/scene.h"
#include "scene/scene_number.h"

namespace occlude::culler {

/// Makes room for one more, so that adding it cannot fail. Room grows by one part in `share`: the more parts, the less of it
/// stays empty, and the more often elements are copied.
template <class T>
void make_room(std::vector<T>& v, std::size_t share) {
  if (v.size() == v.capacity()) v.reserve(v.size() + std::max<std::size_t>(16, v.size() / share));
}

/// What there is once for each thing for as long as that is in the scene is not to have much empty room. It is small.
constexpr std::size_t kShareOfLasting = 16;

/// `Id` is a SceneId, and a `Thing` is copied as its bytes are. What is removed makes place for another, whose id has
/// another generation. If add() throws, nothing has changed; remove() throws nothing but for an unknown id.
template <class Id, class Thing>
class Slots {
 public:
  /// The ids are of this scene.
  explicit Slots(SceneNumber& scene) : scene_(scene), of_scene_(Id(0, 0, scene.number()).number()) {}

  Id add(Thing thing) {
    if (free_ == kNone) add_slot();
    const std::uint32_t i = free_;
    free_ = slots_[i].next_free;
    std::construct_at(&slots_[i].thing, thing);
    slots_[i].is_used = true;
    scene_.use(slots_[i].generation);
    ++count_;
    return id(i);
  }
  void remove(Id id) {
    if (!contains(id)) refuse(id);
    Slot& slot = slots_[id.slot()];
    slot.is_used = false;
    --count_;
    // A slot whose generations have all been used is not used again.
    if (++slot.generation >> Id::kGenerationBits == 0) free(id.slot());
  }

  [[nodiscard]] bool contains(Id id) const {
    return id.slot() < slots_.size() && slots_[id.slot()].is_used && this->id(id.slot()) == id;
  }
  /// Why there is no such thing; empty if there is.
  [[nodiscard]] std::string fault(Id id) const {
    if (contains(id)) return {};
    if (id.is_none()) return "the id is none";
    if (id.kind() != Id::kKind) return "the id is that of an " + name(id.kind()) + ", not of an " + name(Id::kKind);
    if (id.scene() != scene_.number()) return "the id is that of another scene";
    return "the scene has no such " + name(Id::kKind);
  }
  /// Throws std::invalid_argument if there is no such thing.
  [[nodiscard]] Thing& operator[](Id id) {
    if (!contains(id)) refuse(id);
    return slots_[id.slot()].thing;
  }
  /// The same for several, with the place.
  void require(std::span<const Id> ids) const {
    const auto unknown = std::ranges::find_if_not(ids, [&](Id id) { return contains(id); });
    if (unknown == ids.end()) return;
    throw std::invalid_argument(name(Id::kKind) + " " + std::to_string(unknown - ids.begin()) + ": " + fault(*unknown));
  }
  /// The thing in a slot. REQUIRES: there is one.
  [[nodiscard]] Thing& at(std::uint32_t slot) { return slots_[slot].thing; }

  /// The number of things, and that of slots.
  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] std::size_t slots() const { return slots_.size(); }
  /// For how many slots there is room.
  [[nodiscard]] std::size_t capacity() const { return slots_.capacity(); }
  [[nodiscard]] std::size_t bytes() const { return slots_.capacity() * sizeof(Slot); }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  struct Slot {
    union {
      Thing thing;              ///< if it is used
      std::uint32_t next_free;  ///< else
    };
    std::uint32_t is_used : 1, generation : Id::kGenerationBits + 1;
  };

  static std::string name(SceneKind kind) { return kind == SceneKind::object ? "object" : "occluder"; }

  [[nodiscard]] Id id(std::uint32_t slot) const {
    return Id::from_number(of_scene_ | std::uint64_t{slots_[slot].generation} << Id::kSlotBits | slot);
  }

  /// By itself, so that what is inlined is the question alone.
  [[noreturn]] void refuse(Id id) const { throw std::invalid_argument(fault(id)); }

  void add_slot() {
    const std::size_t slot = slots_.size();
    if (slot >> Id::kSlotBits != 0) throw std::runtime_error("the scene has no room for another " + name(Id::kKind));
    make_room(slots_, kShareOfLasting);
    slots_.push_back({{.next_free = kNone}, 0, scene_.first_generation() & ((1U << (Id::kGenerationBits + 1)) - 1)});
    free(static_cast<std::uint32_t>(slot));
  }
  void free(std::uint32_t slot) {
    slots_[slot].next_free = free_;
    free_ = slot;
  }

  SceneNumber& scene_;
  std::uint64_t of_scene_;  ///< the number of the first id
  std::vector<Slot> slots_;
  std::uint32_t free_ = kNone;  ///< the first of the free slots, each of which has the next
  std::size_t count_ = 0;
};

}  // namespace occlude::culler
