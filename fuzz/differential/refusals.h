// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "report.h"

namespace occlude::fuzz {

/// Cases of any family with something wrong about them: who refuses, and who answers what.
void run_refusals(std::uint64_t seed, Report& report);

}  // namespace occlude::fuzz
