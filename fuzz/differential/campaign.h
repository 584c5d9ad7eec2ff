// SPDX-License-Identifier: MIT
// Runs many groups of cases of many experiments, on many threads or machines. The results do not depend on how the groups
// are dealt.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "experiment.h"

namespace occlude::fuzz {

/// Round r makes the group with seed `seed` + r of every experiment. A shard takes every `shards`-th round.
struct Campaign {
  std::uint64_t seed = 1;
  std::uint64_t rounds = 0;
  std::uint64_t shard = 0, shards = 1;
  unsigned jobs = 1;
};

/// The number of rounds that the shard takes.
[[nodiscard]] std::uint64_t rounds_of_shard(const Campaign& campaign);

/// Returns one report for each experiment, in their order. Before every group, the thread that is about to run it calls
/// `go_on` with the numbers of groups and findings so far. After that returns false, groups under way are finished and no
/// others are begun. An exception from an experiment is a finding. REQUIRES: shard < shards.
[[nodiscard]] std::vector<Report> run(const Campaign& campaign, std::span<const Experiment> experiments,
                                      const std::function<bool(std::uint64_t groups, std::uint64_t findings)>& go_on);

}  // namespace occlude::fuzz
