// SPDX-License-Identifier: MIT
// What a benchmark found, for people and for programs.
#pragma once

#include <string>

#include "bench.h"

namespace occlude::bench {

/// Where it was measured.
struct Machine {
  std::string processor, compiler, flags;
  unsigned threads = 0;
};

[[nodiscard]] std::string report_text(const Result& result, const Machine& machine);

/// One object. What could not be measured here is null.
[[nodiscard]] std::string report_json(const Result& result, const Machine& machine);

}  // namespace occlude::bench
