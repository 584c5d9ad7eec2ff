// SPDX-License-Identifier: MIT
// Compares frames by cover with the oracle.
#pragma once

#include <cstdint>

#include "report.h"

namespace occlude::fuzz {

/// Checks a small scene from a few viewpoints: every polygon is drawn or culled once, and every cull by cover is proved.
void run_joined(std::uint64_t seed, Report& report);

}  // namespace occlude::fuzz
