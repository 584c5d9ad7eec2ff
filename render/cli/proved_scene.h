// SPDX-License-Identifier: MIT
// The benchmark of scenes with culls that are proved by the oracle.
#pragma once

#include "scene_bench.h"

namespace occlude::cli {

/// Shows progress. Throws Interrupted on Ctrl-C.
[[nodiscard]] experiments::SceneBenchResult measure_scene(const experiments::SceneBenchOptions& options);

/// Whether all that was checked is as it should be.
[[nodiscard]] inline bool is_right(const experiments::SceneBenchResult& result) {
  return result.different == 0 && result.unproved == 0;
}

}  // namespace occlude::cli
