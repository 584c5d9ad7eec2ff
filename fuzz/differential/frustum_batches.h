// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "report.h"

namespace occlude::fuzz {

/// Compares a box with the shadows of many cases at once (kernel/batch.h).
void run_frustum_batch(std::uint64_t seed, Report& report);

}  // namespace occlude::fuzz
