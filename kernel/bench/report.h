// SPDX-License-Identifier: MIT
// The results of a benchmark, as text for people and as JSON for programs.
#pragma once

#include <string>
#include <vector>

#include "bench.h"
#include "table.h"

namespace occlude::bench {

/// The machine on which the benchmark ran.
struct Machine {
  std::string processor, compiler, flags;
  unsigned threads = 0;
};

/// Workloads, times, ratios, and Table 1.
[[nodiscard]] std::vector<Table> tables_of(const Result& result, const Machine& machine);
[[nodiscard]] std::string report_text(const Result& result, const Machine& machine);

/// A single JSON object. What could not be measured on this machine is null.
[[nodiscard]] std::string report_json(const Result& result, const Machine& machine);

}  // namespace occlude::bench
