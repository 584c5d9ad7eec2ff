// SPDX-License-Identifier: MIT
// Sorting on all processors, in steps short enough to stop between them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

#include "base/parallel.h"

namespace occlude::culler {

/// Sorts as std::stable_sort does, with the same result for any number of processors: pieces are sorted, and then merged two
/// by two.
template <class T, class Less = std::less<>>
void parallel_sort(std::vector<T>& values, const Checkpoint& checkpoint, Less less = {}) {
  constexpr std::size_t kPiece = std::size_t{1} << 16U;  // takes some milliseconds
  const auto at = [&](std::size_t i) { return values.begin() + static_cast<std::ptrdiff_t>(std::min(i, values.size())); };
  const auto for_each_piece = [&](std::size_t length, auto&& work) {
    const auto one = [&](std::size_t i) { work(i * length); };
    parallel_for((values.size() + length - 1) / length, one, checkpoint);
  };
  for_each_piece(kPiece, [&](std::size_t first) { std::stable_sort(at(first), at(first + kPiece), less); });
  for (std::size_t length = kPiece; length < values.size(); length *= 2) {
    for_each_piece(2 * length, [&](std::size_t first) {
      std::inplace_merge(at(first), at(first + length), at(first + 2 * length), less);
    });
  }
}

}  // namespace occlude::culler
