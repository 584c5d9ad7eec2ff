// SPDX-License-Identifier: MIT
// The shadow frustum in plain doubles, good for aiming only: whether a case is what it was meant to be, the oracle says.
#pragma once

#include <vector>

#include "scene.h"

namespace occlude::fuzz {

/// normal . (x - point) >= 0, the normal pointing into the frustum.
struct SketchPlane {
  Vec3 normal, point;

  [[nodiscard]] double height(const Vec3& x) const { return dot(normal, x - point); }
};

/// What the viewpoint sees of the occluder; a polygon is its own silhouette and its only front face.
struct Outline {
  Loop silhouette;
  std::vector<Loop> front;  ///< faces turned to the viewpoint
};

/// The direction in which a point is seen.
[[nodiscard]] Vec3 sight(const Scene& scene, const Vec3& point);

/// Whether a face of a polytope is turned to the viewpoint; one seen edge-on is not.
[[nodiscard]] bool is_front(const Scene& scene, const Loop& face);

/// REQUIRES: a polygon, or a polytope with a front face.
[[nodiscard]] Outline outline_of(const Scene& scene);

/// Of the silhouette's vertices; the lowest index on a tie.
[[nodiscard]] std::size_t farthest_vertex(const Scene& scene, const Outline& outline);

/// One plane an edge of the silhouette, in order, and then the near planes: one for `farthest`, for `surface` one a front
/// face. An edge seen as a point has the normal zero.
[[nodiscard]] std::vector<SketchPlane> sketch(const Scene& scene, const Outline& outline);

}  // namespace occlude::fuzz
