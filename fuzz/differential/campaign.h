// SPDX-License-Identifier: MIT
// Many groups of cases of many experiments, on many threads or machines: what comes out does not depend on how they are
// dealt.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "experiment.h"

namespace occlude::fuzz {

/// Round r makes the group of seed `seed` + r of every experiment. A shard takes every `shards`-th round.
struct Campaign {
  std::uint64_t seed = 1;
  std::uint64_t rounds = 0;
  std::uint64_t shard = 0, shards = 1;
  unsigned jobs = 1;
};

/// The rounds that are the shard's own.
[[nodiscard]] std::uint64_t rounds_of_shard(const Campaign& campaign);

/// One report an experiment, in their order. `go_on` is asked before every group by any of the threads, with the number of
/// findings so far; once it says no, groups under way are finished and no others begun. What an
/// experiment throws is a finding. REQUIRES: shard < shards.
[[nodiscard]] std::vector<Report> run(const Campaign& campaign, std::span<const Experiment> experiments,
                                      const std::function<bool(std::uint64_t groups, std::uint64_t findings)>& go_on);

}  // namespace occlude::fuzz
