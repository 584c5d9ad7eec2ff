// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "report.h"

namespace occlude::fuzz {

/// What a viewpoint sees of two convex objects, by the general test (kernel/view_cone.h): occluders of any case, parts of
/// them, the sides of boxes. Silhouettes and farthest vertices on the way.
void run_cones(std::uint64_t seed, Report& report);

/// Convex polytopes in the place of boxes (kernel/polytope_overlap.h): boxes and their corners, and occluders themselves.
void run_occludees(std::uint64_t seed, Report& report);

}  // namespace occlude::fuzz
