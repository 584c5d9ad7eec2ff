// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "report.h"

namespace occlude::fuzz {

/// Damaged cases of any family: which side refuses, and which answers.
void run_refusals(std::uint64_t seed, Report& report);

}  // namespace occlude::fuzz
