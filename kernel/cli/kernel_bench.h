// SPDX-License-Identifier: MIT
// The kernel's benchmark as the commands run it.
#pragma once

#include "bench.h"
#include "report.h"

namespace occlude::cli {

/// Measures the kernel, and other projects where their program lies beside this one; says so where that fails. Shows
/// progress. Throws Interrupted on Ctrl-C.
[[nodiscard]] bench::Result measure_kernel(bench::Options options);

}  // namespace occlude::cli
