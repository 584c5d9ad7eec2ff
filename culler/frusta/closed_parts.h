// SPDX-License-Identifier: MIT
// The parts of a soup, and which of them are closed.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "occlude/culler/executor.h"
#include "occlude/culler/polygon_soup.h"

namespace occlude::culler {

/// The polygons of each part, ascending; the parts, too, by their first polygons. Two polygons are in one part if they share
/// a corner, or if both share one with others of it. `weld` is the result of welded() (adjacency.h): corners with equal
/// coordinates count as one.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> find_parts(SoupView soup, std::span<const std::uint32_t> weld,
                                                                 const Checkpoint& checkpoint = {});

/// Whether the part is opaque, and every edge of it runs along an even number of sides. A side between two equal corners is
/// none. The part may be turned either way, cross itself, or have edges where four polygons meet.
[[nodiscard]] bool is_closed(SoupView soup, std::span<const std::uint32_t> weld, std::span<const std::uint32_t> part);

}  // namespace occlude::culler
