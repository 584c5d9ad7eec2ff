// SPDX-License-Identifier: MIT
// The shadow frustum of a workload, cut off beyond all its boxes, for libraries that only know bounded shapes.
#pragma once

#include <array>
#include <cstddef>

#include "workloads.h"

namespace occlude::bench {

/// A frustum of six quadrilateral faces. For the boxes of the workload it is the same as the shadow, up to the rounding of
/// the far corners.
struct BoundedFrustum {
  using Face = std::array<std::size_t, 4>;

  explicit BoundedFrustum(const Workload& workload);

  std::array<kernel::Vec3, 8> corners;  ///< 0 to 3: of the near face; i + 4: on the ray through i
  kernel::Vec3 center;

  /// The corners of each face, counter-clockwise seen from outside: the near face, the sides, the far face. The silhouette
  /// turns clockwise seen from the eye, because the values det(s_i - V, s_(i+1) - V, x - V) of its side planes are positive
  /// inside.
  static constexpr std::array<Face, 6> kFaces{
      {{3, 2, 1, 0}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}}};
};

}  // namespace occlude::bench
