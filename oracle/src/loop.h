// SPDX-License-Identifier: MIT
// A loop of vertices seen from a viewpoint: whether it is a convex polygon, and which way it turns.
#pragma once

#include <optional>
#include <string>

#include "numbers.h"

namespace occlude::oracle {

/// The sign that every edge's side plane has on the inner side of the loop, when the loop seen along `direction` is a convex
/// polygon wound once. ZERO for a loop seen edge-on. Empty for a loop that is not convex.
[[nodiscard]] std::optional<CGAL::Sign> turn_along(const Point& direction, const Loop& loop);

/// Whether all vertices lie in one plane. REQUIRES: the loop is convex seen from somewhere.
[[nodiscard]] bool is_coplanar(const Loop& loop);

/// A polygon seen from a viewpoint: its fault, or the way it turns.
struct Seen {
  std::string fault;
  CGAL::Sign turn = CGAL::ZERO;
};

/// Checks that the loop, seen from the viewpoint, is a convex polygon wound once, and that the viewpoint is neither in its
/// plane nor in the polygon.
[[nodiscard]] Seen see(const Viewpoint& view, const Loop& loop);

}  // namespace occlude::oracle
