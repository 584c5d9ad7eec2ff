// SPDX-License-Identifier: MIT
// Whether several polygons hide what one occluder does.
#pragma once

#include <span>

#include "cases/case.h"

namespace occlude::proof {

using cases::Polygon;

/// Whether the parts have the loop as their common border, with every edge but those of the loop run through as often one
/// way as the other, and no vertex that is not the loop's. Then they hide what the loop does as an occluder: seen from a
/// viewpoint from which the loop is convex they cover it, as any surface covers what its border winds around; and between
/// corners on one side of a plane they lie there too.
[[nodiscard]] bool have_border(std::span<const Polygon> parts, const Polygon& loop);

}  // namespace occlude::proof
