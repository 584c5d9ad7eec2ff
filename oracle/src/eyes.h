// SPDX-License-Identifier: MIT
// A region of eyes, in either number type.
#pragma once

#include <algorithm>
#include <vector>

#include "corners.h"
#include "occlude/oracle/region.h"
#include "plane.h"

namespace occlude::oracle {

/// The points no farther than `radius` from the hull of `corners`.
template <class N>
struct Eyes {
  std::vector<Vector<N>> corners;
  N radius = N(0);
  bool is_round = false;  ///< whether the radius is not zero
};

template <class N>
Eyes<N> eyes_of(const EyeRegion& region) {
  if (const Obb* box = std::get_if<Obb>(&region)) return {corners_of<N>(*box), N(0), false};
  const auto& [center, radius] = std::get<Ball>(region);
  return {{vector_of<N>(center)}, N(radius), radius > 0};
}

/// The sign of the least height of an eye over the half-space. Squares are compared, so no root is needed.
template <class N>
CGAL::Sign least_side(const Eyes<N>& eyes, const HalfSpace<N>& half_space) {
  CGAL::Sign least = CGAL::POSITIVE;
  for (const Vector<N>& corner : eyes.corners) {
    const N height = half_space.height(corner);
    CGAL::Sign side = certain_sign(height);
    if (eyes.is_round && side != CGAL::NEGATIVE) {
      side = certain_sign(N(height * height - eyes.radius * eyes.radius * (half_space.normal * half_space.normal)));
    }
    least = std::min(least, side);
  }
  return least;
}

}  // namespace occlude::oracle
