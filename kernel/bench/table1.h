// SPDX-License-Identifier: MIT
// Table 1 of the paper: what a test costs at worst and at best, in operations.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "occlude/kernel/operations.h"
#include "workloads.h"

namespace occlude::bench {

/// Of each kind of operation the most and the fewest that any box costs.
struct Cost {
  std::string test;
  kernel::Operations worst, best;
};

/// The paper's rows.
[[nodiscard]] std::vector<Cost> paper_costs();

/// The kernel's tests, counted over all boxes of all workloads. REQUIRES: there is a box.
[[nodiscard]] std::vector<Cost> measured_costs(std::span<const Workload> workloads);

}  // namespace occlude::bench
