// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "report.h"

namespace occlude::fuzz {

/// Compares boxes with the joined shadow of several polygons (kernel/cover.h): pieces of a polygon that fit exactly or
/// nearly, and any polygons on a lattice.
void run_covers(std::uint64_t seed, Report& report);

}  // namespace occlude::fuzz
