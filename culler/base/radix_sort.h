// SPDX-License-Identifier: MIT
// Sorts what is numbered by nodes of a tree, in the same time for each element.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace occlude::culler {

/// Sorts by a key below `end`, which is std::invoke(key, value). Elements with the same key stay in their order. `room` is
/// memory, and its elements are lost.
template <class T, class Key>
void radix_sort(std::vector<T>& values, std::vector<T>& room, std::uint64_t end, const Key& key) {
  // The counts of 2^11 digits are 8 KiB, which the first-level cache holds beside what is moved.
  constexpr unsigned kDigitBits = 11;
  constexpr std::uint32_t kDigits = 1U << kDigitBits;
  room.resize(values.size());
  for (unsigned shift = 0; shift < 32 && end >> shift != 0; shift += kDigitBits) {
    const auto digit = [&](const T& value) { return std::uint32_t{std::invoke(key, value)} >> shift & (kDigits - 1); };
    std::array<std::uint32_t, kDigits> starts{};
    for (const T& value : values) ++starts[digit(value)];
    std::uint32_t start = 0;
    for (std::uint32_t& count : starts) start += std::exchange(count, start);
    for (const T& value : values) room[starts[digit(value)]++] = value;
    values.swap(room);
  }
}

}  // namespace occlude::culler
