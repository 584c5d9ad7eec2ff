// SPDX-License-Identifier: MIT
// The results of a run of the fuzzer, as a table and as JSON.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "differential/report.h"

namespace occlude::cli {

struct FuzzResults {
  struct Row {
    std::string name;
    fuzz::Report report;
  };
  std::optional<std::uint64_t> seed;  ///< empty for the lines of case files
  /// Rounds of the whole run. 0 when the run was to end by time, at the first finding, or with the lines of files.
  std::uint64_t rounds = 0;
  bool interrupted = false;  ///< by the user, before the run was complete
  std::vector<Row> rows;
};

/// The sum of all rows, without their findings.
[[nodiscard]] fuzz::Report total(const FuzzResults& results);

/// Every finding that a case file can hold, each on a line.
[[nodiscard]] std::string case_lines(const FuzzResults& results);

[[nodiscard]] std::string table(const FuzzResults& results);

[[nodiscard]] std::string to_json(const FuzzResults& results);

}  // namespace occlude::cli
