// SPDX-License-Identifier: MIT
// What a run of the fuzzer gives: as a table, as JSON, and the results of several shards as those of one run.
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
  std::optional<std::uint64_t> seed;  ///< none for the lines of case files
  /// Of the whole run; 0 when it was to end by the time, by a finding, or with the lines.
  std::uint64_t rounds = 0;
  std::uint64_t shards = 1;
  std::vector<std::uint64_t> parts;  ///< the shards that are in it
  bool interrupted = false;          ///< by the user: there would have been more
  std::vector<Row> rows;
};

/// All rows together, without their findings.
[[nodiscard]] fuzz::Report total(const FuzzResults& results);

/// Every finding that a case file can hold, a line each.
[[nodiscard]] std::string case_lines(const FuzzResults& results);

[[nodiscard]] std::string table(const FuzzResults& results);

[[nodiscard]] std::string to_json(const FuzzResults& results);

/// The sum of shards of one run. Throws InputError, naming the file and what is wrong with it, for what is no result of this
/// command, of another run or given before.
[[nodiscard]] FuzzResults merge(const std::vector<std::string>& files);

}  // namespace occlude::cli
