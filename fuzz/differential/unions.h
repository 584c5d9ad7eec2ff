// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "report.h"

namespace occlude::fuzz {

/// Compares boxes with the shadows of two occluders together (kernel/shadow_union.h): parts of one polygon, and others.
void run_unions(std::uint64_t seed, Report& report);

}  // namespace occlude::fuzz
