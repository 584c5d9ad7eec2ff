// SPDX-License-Identifier: MIT
// What preprocess() does, in parts.
#pragma once

#include <cstddef>
#include <vector>

#include "occlude/culler/culler.h"

namespace occlude::culler {

/// What the occluders that regions [first, end) list hide, in the order of their lists: that part of `hidden` of
/// OccluderLists::Stored. On all processors.
[[nodiscard]] std::vector<float> sample_regions(const Culler& culler, const SampleConfig& samples, std::size_t first,
                                                std::size_t end, const Checkpoint& checkpoint = {});

}  // namespace occlude::culler
