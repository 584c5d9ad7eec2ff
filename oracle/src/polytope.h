// SPDX-License-Identifier: MIT
// Whether a polytope is one: closed and convex, its faces plane and convex. Everything is decided from the points alone, by
// trying all of them.
#pragma once

#include <string>
#include <vector>

#include "half_spaces.h"

namespace occlude::oracle {

/// A polytope without fault.
struct Solid {
  std::vector<Point> points;         ///< the distinct vertices, in lexicographic order
  std::vector<Loop> faces;           ///< those that have an area
  std::vector<CGAL::Sign> interior;  ///< the side of each face's plane on which the solid lies

  /// The half-space of the plane of face `f` that holds the solid.
  [[nodiscard]] OrientedPlane half_space(std::size_t f) const { return {LoopPlane{faces[f]}, interior[f]}; }
};

/// A solid, or why the polytope is none.
struct SolidOrFault {
  Solid solid;
  std::string fault;
};

/// REQUIRES: the vertices are legal numbers.
[[nodiscard]] SolidOrFault solid_of(const Polytope& polytope);

}  // namespace occlude::oracle
