// SPDX-License-Identifier: MIT
// The relation of a box to planes, each of which has an inner side.
#pragma once

#include <vector>

#include "box.h"
#include "half_spaces.h"

namespace occlude::oracle {

/// The planes of a question. Each keeps what it computes.
using Planes = std::vector<Plane<OrientedPlane>*>;

inline void append(Planes& planes, std::vector<Plane<OrientedPlane>>& more) {
  for (Plane<OrientedPlane>& plane : more) planes.push_back(&plane);
}

/// Whether some point of the box is on the inner side of every plane or on the plane.
[[nodiscard]] bool share_a_point(const Planes& planes, const Box& box);

/// Relation of the box to the intersection of the inner sides.
[[nodiscard]] Relation relate(const Planes& planes, const Box& box);

}  // namespace occlude::oracle
