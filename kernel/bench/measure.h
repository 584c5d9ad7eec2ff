// SPDX-License-Identifier: MIT
// Measures the times of many passes so that they can be compared.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "occlude/kernel/types.h"
#include "subject.h"

namespace occlude::bench {

/// A pass, its latest answers and its times.
struct Trial {
  Pass pass;
  std::vector<kernel::Relation> answers;
  std::vector<double> ns;  ///< processor time per box, one number per round
};

/// Called between rounds. It may throw to stop the measurement.
using Progress = std::function<void(std::size_t rounds_done)>;

/// Runs every trial once in every round, in an order that is shuffled again for each round. Whatever slows the machine for a
/// while then slows all trials alike, so times of one round may be compared. A round before the first warms up and finds how
/// often to repeat each pass.
void measure(std::span<Trial> trials, std::size_t rounds, const Progress& progress);

}  // namespace occlude::bench
