// SPDX-License-Identifier: MIT
// Times many passes against each other.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "occlude/kernel/types.h"
#include "subject.h"

namespace occlude::bench {

/// A pass and the answers that it last gave.
struct Trial {
  Pass pass;
  std::vector<kernel::Relation> answers;
  std::vector<double> ns;  ///< processor time a box, one number a round
};

/// Called between rounds; may throw to stop.
using Progress = std::function<void(std::size_t rounds_done)>;

/// Runs every trial once in every round, in an order shuffled anew each time, so that whatever slows the machine for a while
/// slows all alike, and numbers of one round may be compared. A round before the first warms up and finds out how often
/// to repeat each pass.
void measure(std::span<Trial> trials, std::size_t rounds, const Progress& progress);

}  // namespace occlude::bench
