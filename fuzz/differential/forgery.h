// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "report.h"

namespace occlude::fuzz {

/// Witness lines of a forger who has the whole file at will, over small scenes and cameras of all openings, shapes, near and
/// far planes and both projections: planes that cut a little or a lot of the view, or overflow, or vanish; boxes, occluders,
/// near planes, ranges, frames, parts and margins that are true or not. A case is a line: `inside` when the prover takes it,
/// `outside` when it does not. What it takes must not show, by exact visibility.
void run_forgeries(std::uint64_t seed, Report& report);

}  // namespace occlude::fuzz
