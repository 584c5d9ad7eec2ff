// SPDX-License-Identifier: MIT
// The test that the paper starts from (the first row of its Table 1), for a frustum with a far plane.
#pragma once

#include <array>

#include "bounded_frustum.h"
#include "occlude/kernel/types.h"

namespace occlude::bench {

/// A quadrilateral face of a convex body.
struct NaiveFace {
  std::array<kernel::Vec3, 4> corners;  ///< counter-clockwise seen from outside
  kernel::Vec3 normal;                  ///< outward
  int axis;                             ///< the axis on which the normal is longest
};

struct NaiveFrustum {
  explicit NaiveFrustum(const BoundedFrustum& frustum);

  std::array<kernel::Vec3, 8> corners;
  std::array<NaiveFace, 6> faces;
};

/// In the worst case this takes 54 half-plane tests (8 box vertices on 6 planes, one frustum vertex on 6 box faces) and 108
/// edge-face tests (12 box edges on 6 frustum faces, 12 frustum edges on the 3 box faces turned to where they start).
[[nodiscard]] kernel::Relation naive_overlap(const NaiveFrustum& frustum, const kernel::Aabb& box);

}  // namespace occlude::bench
