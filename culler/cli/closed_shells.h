// SPDX-License-Identifier: MIT
// Closed surfaces in a soup, also where walls divide what they enclose.
#pragma once

#include <cstdint>
#include <vector>

#include "occlude/culler/executor.h"
#include "occlude/culler/polygon_soup.h"

namespace occlude::cli {

/// Closed shells: opaque polygons such that each edge runs along an even number of their sides. At most one of all that
/// hangs together by edges, with its polygons in ascending order. If that as a whole is no shell, polygons are left out:
/// walls in it, where three polygons meet in an edge, and what stands out from it with free edges. Of polygons with the same
/// corners only one is in a shell.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> closed_shells(culler::SoupView soup,
                                                                    const culler::Checkpoint& checkpoint);

}  // namespace occlude::cli
