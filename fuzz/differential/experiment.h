// SPDX-License-Identifier: MIT
// The rows of the fuzzer's table: each makes cases of one kind and holds the program's answers against the oracle's.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "report.h"

namespace occlude::fuzz {

/// How many cases an experiment makes at a time, at least: they share what is dear to prepare, a shadow or a scene.
inline constexpr std::uint64_t kGroup = 16;

struct Experiment {
  std::string name;
  /// Makes the cases of this seed, kGroup or more, the same on every machine, and adds what they gave to the report.
  std::function<void(std::uint64_t seed, Report& report)> run;
};

/// All of them, the families of cases.h first.
[[nodiscard]] const std::vector<Experiment>& experiments();

}  // namespace occlude::fuzz
