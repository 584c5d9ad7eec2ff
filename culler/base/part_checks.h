// SPDX-License-Identifier: MIT
// Checks of the elements of parts, on several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "base/for_ranges.h"
#include "occlude/culler/executor.h"

namespace occlude::culler {

/// Whether is_sound(i) for every i < count.
template <class IsSound>
[[nodiscard]] bool are_all(std::size_t count, IsSound&& is_sound, const Checkpoint& checkpoint) {
  std::atomic<bool> are_sound = true;
  for_ranges(
      count,
      [&](std::size_t begin, std::size_t end) {
        bool are = true;  // no branch for each, so that simple checks are done several at once
        for (std::size_t i = begin; i < end; ++i) are &= is_sound(i);
        if (!are) are_sound = false;
      },
      checkpoint);
  return are_sound;
}

/// Whether the numbers ascend, each once, and are below `end`.
[[nodiscard]] inline bool are_ascending_below(std::span<const std::uint32_t> numbers, std::size_t end) {
  return std::ranges::adjacent_find(numbers, std::ranges::greater_equal()) == numbers.end() &&
         (numbers.empty() || numbers.back() < end);
}

/// Whether they are the starts of ranges that make up [0, size): they begin with 0, never descend, and end with `size`.
template <class Starts>
[[nodiscard]] bool are_starts(const Starts& starts, std::size_t size, const Checkpoint& checkpoint) {
  return !starts.empty() && starts.front() == 0 && starts.back() == size &&
         are_all(
             starts.size() - 1, [&](std::size_t i) { return starts[i] <= starts[i + 1]; }, checkpoint);
}

}  // namespace occlude::culler
