// SPDX-License-Identifier: MIT
// How a convex polytope lies to planes, of which each has an inner side.
#pragma once

#include "polytope.h"
#include "relate.h"

namespace occlude::oracle {

/// The axis-aligned box that the points span. REQUIRES: there are points.
[[nodiscard]] Aabb bounding_box(const std::vector<Point>& points);

/// Relation of the solid to the intersection of the inner sides.
[[nodiscard]] Relation relate(const Planes& planes, const Solid& solid);

}  // namespace occlude::oracle
