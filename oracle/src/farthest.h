// SPDX-License-Identifier: MIT
// The vertex farthest from a viewpoint, compared exactly.
#pragma once

#include <span>

#include "numbers.h"

namespace occlude::oracle {

/// The vertex that is farthest from the eye, or farthest along the direction of view. On a tie the first. REQUIRES: not
/// empty.
[[nodiscard]] Point farthest_of(const Viewpoint& view, std::span<const Point> vertices);

}  // namespace occlude::oracle
