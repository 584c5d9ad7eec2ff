// SPDX-License-Identifier: MIT
// Numbers a few of many things from 0 on, in the order in which they come.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace occlude::culler {

/// A hash table that is emptied at no cost. Its memory is in proportion to the most things that it has held at once.
class LocalIndex {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  void clear() {
    count_ = 0;
    if (++epoch_ == 0) {
      slots_.assign(slots_.size(), {});
      epoch_ = 1;
    }
  }

  /// Reserves memory for this many things.
  void reserve(std::size_t count) {
    while (slots_.size() < 2 * count) grow();
  }

  [[nodiscard]] std::uint32_t size() const { return count_; }

  /// The number of a thing; kNone if it has none.
  [[nodiscard]] std::uint32_t find(std::uint32_t thing) const {
    const Slot& slot = slots_[slot_of(thing)];
    return slot.epoch == epoch_ ? slot.number : kNone;
  }

  /// The number of a thing. A new thing gets the number size().
  std::uint32_t number(std::uint32_t thing) {
    if (2 * std::size_t{count_} >= slots_.size()) grow();
    Slot& slot = slots_[slot_of(thing)];
    if (slot.epoch != epoch_) slot = {thing, count_++, epoch_};
    return slot.number;
  }

 private:
  struct Slot {
    std::uint32_t thing = 0, number = 0, epoch = 0;
  };

  /// The slot of the thing, or the one that it would take.
  [[nodiscard]] std::size_t slot_of(std::uint32_t thing) const {
    // Neighbours in the model have close numbers. Multiplication by the golden ratio spreads them (Knuth, The Art of
    // Computer Programming, 6.4).
    std::size_t at = (thing * 0x9E3779B9U) >> shift_;
    while (slots_[at].epoch == epoch_ && slots_[at].thing != thing) at = (at + 1) & (slots_.size() - 1);
    return at;
  }

  void grow() {
    const std::vector<Slot> old = std::move(slots_);
    slots_.assign(2 * old.size(), {});
    --shift_;
    for (const Slot& slot : old) {
      if (slot.epoch == epoch_) slots_[slot_of(slot.thing)] = slot;
    }
  }

  std::vector<Slot> slots_ = std::vector<Slot>(256);
  int shift_ = 32 - std::countr_zero(256U);  ///< shifts a hash below slots_.size()
  std::uint32_t count_ = 0, epoch_ = 1;
};

}  // namespace occlude::culler
