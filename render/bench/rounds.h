// SPDX-License-Identifier: MIT
// Timed work runs in rounds, each trial once per round, so that a change of the machine's speed affects all trials.
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
