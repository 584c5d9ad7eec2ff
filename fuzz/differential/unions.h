// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "report.h"

namespace occlude::fuzz {

/// Boxes against the shadows of two occluders at once (kernel/shadow_union.h): parts of one polygon, and others.
void run_unions(std::uint64_t seed, Report& report);

}  // namespace occlude::fuzz
