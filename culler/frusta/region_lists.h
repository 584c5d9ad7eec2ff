// SPDX-License-Identifier: MIT
// Which occluders each region of a partition lists.
#pragma once

#include "frusta/occluder_lists.h"
#include "occlude/culler/executor.h"

namespace occlude::culler {

/// The lists without what occluders hide. On all processors; the same for any number of them.
[[nodiscard]] OccluderLists::Stored list_occluders(const Partition& partition, const PotentialOccluders& occluders,
                                                   const ListConfig& config, const Checkpoint& checkpoint);

}  // namespace occlude::culler
