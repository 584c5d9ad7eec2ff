// SPDX-License-Identifier: MIT
// Whether several polygons together hide what one occluder hides.
#pragma once

#include <span>

#include "cases/case.h"

namespace occlude::proof {

using cases::Polygon;

/// Whether the loop is the common border of the parts: apart from the edges of the loop, every edge occurs as often in one
/// direction as in the other, and every vertex of a part is a vertex of the loop. Such parts hide what the loop hides as an
/// occluder. Seen from a viewpoint from which the loop is convex, they cover it, because any surface covers what its border
/// winds around. Where all vertices of the loop are on one side of a plane, so are the parts.
[[nodiscard]] bool have_border(std::span<const Polygon> parts, const Polygon& loop);

}  // namespace occlude::proof
