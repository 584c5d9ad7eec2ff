// SPDX-License-Identifier: MIT
// What is timed runs in rounds, each thing once a round, so that whatever slows the machine slows all alike.
#pragma once

#include <cstddef>
#include <vector>

#include "occlude/render/progress.h"

namespace occlude::experiments {

/// Calls run(trial) for each trial in every round. Throws Interrupted on Ctrl-C, and what run() throws.
template <class Trial, class Run>
void run_in_rounds(const char* name, std::size_t rounds, std::vector<Trial>& trials, const Run& run) {
  render::Progress progress(name, rounds * trials.size());
  std::size_t done = 0;
  for (std::size_t round = 0; round < rounds; ++round) {
    for (Trial& trial : trials) {
      render::check_interrupt();
      run(trial);
      progress.update(++done);
    }
  }
}

}  // namespace occlude::experiments
