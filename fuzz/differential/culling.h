// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "report.h"

namespace occlude::fuzz {

/// Compares frames of the culler with the promises of culling (cull_judge.h) and with a traversal that has no active sets.
/// The scenes are small: walls, boxes and folded loops on a lattice, and soups. The eye is in odd places and moves or jumps.
/// Options are random. A case is a polygon of a frame: `inside` means culled by shadow, `partial` drawn, `outside` culled by
/// view. It counts as decided by the exact stage when the frame needed that stage.
void run_culling(std::uint64_t seed, Report& report);

}  // namespace occlude::fuzz
