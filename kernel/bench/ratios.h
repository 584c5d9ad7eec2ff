// SPDX-License-Identifier: MIT
// The ratios of times that are the results of the benchmark.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench.h"

namespace occlude::bench {

/// The time of `slow` on a workload divided by that of `fast`.
struct Ratio {
  std::string group, name;  ///< the group in the report; the name is empty for a group of one
  std::string slow, fast;   ///< subjects
  std::string workload;
  std::optional<double> value;  ///< empty where one of the two could not be measured
};

[[nodiscard]] std::vector<Ratio> ratios(const Result& result);

/// The time of each way to ask a peer, on `random`, over that of the certified overlap test in the same rounds. The group is
/// the peer; one that is not installed has none.
[[nodiscard]] std::vector<Ratio> peer_ratios(const Result& result);

}  // namespace occlude::bench
