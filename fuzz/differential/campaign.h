// SPDX-License-Identifier: MIT
// Runs many groups of cases of many experiments, on many threads. The results do not depend on how the groups are dealt.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "experiment.h"

namespace occlude::fuzz {

/// Round r makes the group with seed `seed` + r of every experiment.
struct Campaign {
  std::uint64_t seed = 1;
  std::uint64_t rounds = 0;
  unsigned jobs = 1;
};

/// Returns one report for each experiment, in their order. Before every group, the thread that is about to run it calls
/// `go_on` with the number of findings so far. After that returns false, groups under way are finished and no
/// others are begun. An exception from an experiment is a finding.
[[nodiscard]] std::vector<Report> run(const Campaign& campaign, std::span<const Experiment> experiments,
                                      const std::function<bool(std::uint64_t findings)>& go_on);

}  // namespace occlude::fuzz
