// SPDX-License-Identifier: MIT
// Checks that a polytope is closed and convex and that its faces are plane and convex. The points alone decide, and all of
// them are tried.
#pragma once

#include <string>
#include <vector>

#include "half_spaces.h"

namespace occlude::oracle {

/// A polytope that has passed all checks.
struct Solid {
  std::vector<Point> points;         ///< the distinct vertices, in lexicographic order
  std::vector<Loop> faces;           ///< those with an area
  std::vector<CGAL::Sign> interior;  ///< the side of each face's plane on which the solid lies

  /// The half-space that contains the solid and is bounded by the plane of face `f`.
  [[nodiscard]] OrientedPlane half_space(std::size_t f) const { return {LoopPlane{faces[f]}, interior[f]}; }
};

/// A solid, or the fault of the polytope.
struct SolidOrFault {
  Solid solid;
  std::string fault;
};

/// REQUIRES: the vertices are finite and in range.
[[nodiscard]] SolidOrFault solid_of(const Polytope& polytope);

}  // namespace occlude::oracle
