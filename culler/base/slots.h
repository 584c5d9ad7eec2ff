// SPDX-License-Identifier: MIT
// Things of a caller by ids that are never used twice.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace occlude::culler {

/// Makes room for one more, so that adding it cannot fail.
template <class T>
void make_room(std::vector<T>& v) {
  if (v.size() == v.capacity()) v.reserve(std::max<std::size_t>(16, 2 * v.size()));
}

/// `Id` is a SceneId. What is removed makes place for another, whose id has another generation. If add() throws, nothing has
/// changed; remove() throws nothing but for an unknown id.
template <class Id, class Thing>
class Slots {
 public:
  /// `kind` is for messages: "object".
  explicit Slots(const char* kind) : kind_(kind) {}

  Id add(Thing thing) {
    if (free_.empty()) {
      make_room(slots_);
      free_.reserve(slots_.capacity());  // so that removing cannot fail
      free_.push_back(static_cast<std::uint32_t>(slots_.size()));
      slots_.emplace_back();
    }
    const std::uint32_t i = free_.back();
    free_.pop_back();
    slots_[i].thing = std::move(thing);
    slots_[i].is_used = true;
    ++count_;
    return {i, slots_[i].generation};
  }
  void remove(Id id) {
    static_cast<void>((*this)[id]);
    Slot& slot = slots_[id.slot];
    slot.thing = {};
    slot.is_used = false;
    --count_;
    // A slot whose generations have all been used is not used again.
    if (++slot.generation != 0) free_.push_back(id.slot);
  }

  [[nodiscard]] bool contains(Id id) const {
    return id.slot < slots_.size() && slots_[id.slot].is_used && slots_[id.slot].generation == id.generation;
  }
  /// Throws std::invalid_argument if there is no such thing.
  [[nodiscard]] Thing& operator[](Id id) {
    if (!contains(id)) throw std::invalid_argument(std::string("the scene has no such ") + kind_);
    return slots_[id.slot].thing;
  }
  /// The thing in a slot. REQUIRES: slot < slots(). It is empty if the slot is.
  [[nodiscard]] Thing& at(std::uint32_t slot) { return slots_[slot].thing; }

  /// The number of things, and that of slots.
  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] std::size_t slots() const { return slots_.size(); }
  [[nodiscard]] std::size_t bytes() const {
    return slots_.capacity() * sizeof(Slot) + free_.capacity() * sizeof(std::uint32_t);
  }

  /// Calls visit(id, thing) for all, in the order of their slots.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::uint32_t i = 0; i < slots_.size(); ++i) {
      if (slots_[i].is_used) visit(Id{i, slots_[i].generation}, slots_[i].thing);
    }
  }

 private:
  struct Slot {
    Thing thing{};
    std::uint32_t generation = 0;
    bool is_used = false;
  };

  const char* kind_;
  std::vector<Slot> slots_;
  std::vector<std::uint32_t> free_;
  std::size_t count_ = 0;
};

}  // namespace occlude::culler
