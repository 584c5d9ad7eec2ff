// SPDX-License-Identifier: MIT
// Frames by cover against the oracle.
#pragma once

#include <cstdint>

#include "report.h"

namespace occlude::fuzz {

/// One small scene from a few viewpoints: every polygon is drawn or culled once, every cull by cover is proved.
void run_joined(std::uint64_t seed, Report& report);

}  // namespace occlude::fuzz
