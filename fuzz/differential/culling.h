// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "report.h"

namespace occlude::fuzz {

/// Frames of the culler over small scenes: walls, boxes and folded loops on a lattice, soups, eyes in odd places that move
/// or jump, every option. A case is a polygon of a frame: `inside` culled by shadow, `partial` drawn, `outside` culled by
/// the view; decided by the exact stage where the frame needed it. Held against the promises of culling (cull_judge.h) and a
/// traversal that keeps no active sets.
void run_culling(std::uint64_t seed, Report& report);

}  // namespace occlude::fuzz
