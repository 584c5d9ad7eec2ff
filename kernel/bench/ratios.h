// SPDX-License-Identifier: MIT
// The figures that the benchmark is for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench.h"

namespace occlude::bench {

/// How many times as long `slow` takes as `fast` on a workload.
struct Ratio {
  std::string group, name;  ///< one group of the report; the name is empty for a group of one
  std::string slow, fast;   ///< subjects
  std::string workload;
  std::optional<double> value;  ///< none where one of the two could not be measured
};

[[nodiscard]] std::vector<Ratio> ratios(const Result& result);

}  // namespace occlude::bench
