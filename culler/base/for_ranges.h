// SPDX-License-Identifier: MIT
// Short steps on several threads.
#pragma once

#include <algorithm>
#include <cstddef>

#include "base/parallel.h"
#include "occlude/culler/executor.h"

namespace occlude::culler {

/// Calls work(begin, end) for ranges that make up [0, count), in parallel.
template <class Work>
void for_ranges(std::size_t count, Work&& work, const Checkpoint& checkpoint) {
  constexpr std::size_t kRange = std::size_t{1} << 14U;  // elements; takes a millisecond at most
  parallel_for((count + kRange - 1) / kRange, [&](std::size_t i) { work(i * kRange, std::min(count, (i + 1) * kRange)); },
               checkpoint);
}

}  // namespace occlude::culler
