// SPDX-License-Identifier: MIT
// Which occluders each region of a grid lists.
#pragma once

#include "occlude/culler/checkpoint.h"
#include "occlude/culler/occluder_grid.h"

namespace occlude::culler {

/// The lists of a grid that has none yet, without what occluders hide. On all processors; the same for any number of them.
[[nodiscard]] OccluderGrid::Lists list_occluders(const OccluderGrid& grid, const PotentialOccluders& occluders,
                                                 const OccluderGrid::Config& config, const Checkpoint& checkpoint);

}  // namespace occlude::culler
