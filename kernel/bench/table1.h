// SPDX-License-Identifier: MIT
// Table 1 of the paper: the cost of a test at worst and at best, in operations.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "occlude/kernel/operations.h"
#include "workloads.h"

namespace occlude::bench {

/// For each kind of operation, the most and the fewest that any box takes.
struct Cost {
  std::string test;
  kernel::Operations worst, best;
};

/// The rows of the paper's table.
[[nodiscard]] std::vector<Cost> paper_costs();

/// The kernel's tests, counted over all boxes of all workloads. REQUIRES: there is a box.
[[nodiscard]] std::vector<Cost> measured_costs(std::span<const Workload> workloads);

}  // namespace occlude::bench
