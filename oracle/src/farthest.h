// SPDX-License-Identifier: MIT
// Which of some vertices is the farthest from a viewpoint, compared exactly.
#pragma once

#include <span>

#include "numbers.h"

namespace occlude::oracle {

/// The first of the vertices that none is farther than: from the eye, or along the direction of view. REQUIRES: not empty.
[[nodiscard]] Point farthest_of(const Viewpoint& view, std::span<const Point> vertices);

}  // namespace occlude::oracle
