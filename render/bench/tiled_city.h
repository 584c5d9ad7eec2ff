// SPDX-License-Identifier: MIT
// A large model in which a camera near the ground sees what it sees in a small one.
#pragma once

#include <cstddef>

#include "occlude/render/city.h"

namespace occlude::experiments {

/// The city again and again, side by side on a grid, the first in the middle, until there are at least so many polygons. The
/// path is that of the first. REQUIRES: the city has a polygon, and 0 < polygons.
[[nodiscard]] render::City tiled(const render::City& city, std::size_t polygons);

}  // namespace occlude::experiments
