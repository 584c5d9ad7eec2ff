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

}  // namespace occlude::bench
