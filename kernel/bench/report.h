// SPDX-License-Identifier: MIT
// The results of a benchmark, as text for people and as JSON for programs.
#pragma once

#include <string>
#include <vector>

#include "bench.h"
#include "occlude/render/table.h"

namespace occlude::bench {

/// Workloads, times, ratios, and Table 1.
[[nodiscard]] std::vector<render::Table> tables_of(const Result& result);
[[nodiscard]] std::string report_text(const Result& result);

[[nodiscard]] nlohmann::ordered_json json_of(const std::vector<PeerSummary>& peers);

/// A single JSON object. What could not be measured on this machine is null.
[[nodiscard]] std::string report_json(const Result& result);

}  // namespace occlude::bench
