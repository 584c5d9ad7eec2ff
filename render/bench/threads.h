// SPDX-License-Identifier: MIT
// One cull by frusta on several threads.
#pragma once

#include <cstddef>
#include <vector>

#include "setting.h"

namespace occlude::experiments {

/// Medians over the rounds.
struct ThreadsPoint {
  std::size_t threads;
  double cull_ms = 0;       ///< per frame, by the clock; mean over the frames
  double speedup = 1;       ///< over one thread in the same round
  double most_speedup = 1;  ///< of that many culls at once, each of a view of its own, over one after another
  double call_us = 0;       ///< until all threads have been called and have returned, with nothing to do
};

/// On 1, 2, 4, ... threads, as many as there are processors. Each round walks with each number once. What is gained depends
/// on how fast each processor is, and on where they are: in one core, in cores that share a cache, or farther apart.
/// `most_speedup` and `call_us` tell.
[[nodiscard]] std::vector<ThreadsPoint> measure_threads(const Subject& subject, const Options& options);

}  // namespace occlude::experiments
