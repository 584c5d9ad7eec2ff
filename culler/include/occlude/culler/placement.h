// SPDX-License-Identifier: MIT
// Where a mesh stands in a scene. Reading order: 13.
#pragma once

#include "occlude/kernel/types.h"

namespace occlude::culler {

/// An affine map: the point p of a mesh is at p.x x + p.y y + p.z z + origin in the scene. The columns need be neither unit
/// vectors nor perpendicular, so a mesh may be scaled, sheared and mirrored.
struct Placement {
  kernel::Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  kernel::Vec3 origin{0, 0, 0};

  friend bool operator==(const Placement&, const Placement&) = default;
};

}  // namespace occlude::culler
