// SPDX-License-Identifier: MIT
// The relation of a convex polytope to planes, each of which has an inner side.
#pragma once

#include <span>

#include "polytope.h"
#include "relate.h"

namespace occlude::oracle {

/// The axis-aligned bounding box of the points. REQUIRES: there is at least one point.
[[nodiscard]] Aabb bounding_box(std::span<const Point> points);

/// Relation of the solid to the intersection of the inner sides.
[[nodiscard]] Relation relate(const Planes& planes, const Solid& solid);

}  // namespace occlude::oracle
