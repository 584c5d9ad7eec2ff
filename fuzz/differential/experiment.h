// SPDX-License-Identifier: MIT
// The rows of the fuzzer's table. Each makes cases of one kind and compares the program's answers with the oracle's.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "report.h"

namespace occlude::fuzz {

/// The least number of cases that an experiment makes at a time. They share what is expensive to prepare: a shadow or a
/// scene.
inline constexpr std::uint64_t kGroup = 16;

struct Experiment {
  std::string name;
  /// Makes the cases of this seed, at least kGroup, the same on every machine. Adds their results to the report.
  std::function<void(std::uint64_t seed, Report& report)> run;
};

/// All experiments, the families of cases.h first.
[[nodiscard]] const std::vector<Experiment>& experiments();

}  // namespace occlude::fuzz
