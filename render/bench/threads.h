// SPDX-License-Identifier: MIT
// One cull by frusta on several threads.
#pragma once

#include <cstddef>
#include <vector>

#include "setting.h"

namespace occlude::experiments {

struct ThreadsPoint {
  std::size_t threads;
  double cull_ms = 0;  ///< per frame, by the clock; median over the rounds of the mean over the frames
  double speedup = 1;  ///< over one thread in the same round; median over the rounds
};

/// On 1, 2, 4, ... threads, as many as there are processors. Each round walks with each number once.
[[nodiscard]] std::vector<ThreadsPoint> measure_threads(const Subject& subject, const Options& options);

}  // namespace occlude::experiments
