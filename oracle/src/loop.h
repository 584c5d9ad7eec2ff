// SPDX-License-Identifier: MIT
// A loop of vertices seen from a viewpoint: whether it is a convex polygon, and how it turns.
#pragma once

#include <optional>
#include <string>

#include "numbers.h"

namespace occlude::oracle {

/// The sign that every edge's side plane has on the inner side of a loop that is seen along the direction as a convex
/// polygon wound once; ZERO for a loop seen edge-on, none for one that is not convex.
[[nodiscard]] std::optional<CGAL::Sign> turn_along(const Point& direction, const Loop& loop);

/// Whether all vertices lie in the plane of a loop that is convex from somewhere.
[[nodiscard]] bool is_coplanar(const Loop& loop);

/// What a viewpoint sees of a polygon: what is wrong with it, or its turn.
struct Seen {
  std::string fault;
  CGAL::Sign turn = CGAL::ZERO;
};

/// Whether the loop is a convex polygon seen from the viewpoint, wound once, the viewpoint not in its plane nor in it.
[[nodiscard]] Seen see(const Viewpoint& view, const Loop& loop);

}  // namespace occlude::oracle
