// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "report.h"

namespace occlude::fuzz {

/// Boxes against the joined shadow of several polygons (kernel/cover.h): polygons in pieces that fit, or nearly, and any on
/// a lattice.
void run_covers(std::uint64_t seed, Report& report);

}  // namespace occlude::fuzz
