// SPDX-License-Identifier: MIT
// The shadow frustum in plain doubles, good for aiming only: whether a case is what it was meant to be, the oracle says.
#pragma once

#include <vector>

#include "occlude/fuzz/cases.h"
#include "vector_math.h"

namespace occlude::fuzz {

/// normal . (x - point) >= 0, the normal pointing into the frustum.
struct SketchPlane {
  Vec3 normal, point;

  [[nodiscard]] double height(const Vec3& x) const { return dot(normal, x - point); }
};

/// The direction in which a point is seen.
[[nodiscard]] Vec3 sight(const Case& scene, const Vec3& point);

[[nodiscard]] std::size_t farthest_vertex(const Case& scene);

/// One plane a side, in order, and the near plane last. An edge seen as a point has the normal zero.
[[nodiscard]] std::vector<SketchPlane> sketch(const Case& scene);

}  // namespace occlude::fuzz
