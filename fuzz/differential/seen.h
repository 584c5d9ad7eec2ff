// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "report.h"

namespace occlude::fuzz {

/// Compares what a viewpoint sees of two convex objects by the general test (kernel/view_cone.h). The objects are occluders
/// of any case, parts of them and faces of boxes. Silhouettes and farthest vertices are compared as well.
void run_cones(std::uint64_t seed, Report& report);

/// The same for convex polytopes instead of boxes (kernel/polytope_overlap.h): boxes, tetrahedra of their corners, and
/// occluders.
void run_occludees(std::uint64_t seed, Report& report);

}  // namespace occlude::fuzz
