// SPDX-License-Identifier: MIT
// The shadow frustum in plain doubles. It is only good for aiming: the oracle says what a case really is.
#pragma once

#include <vector>

#include "scene.h"

namespace occlude::fuzz {

/// The half-space normal . (x - point) >= 0. The normal points into the frustum.
struct SketchPlane {
  Vec3 normal, point;

  [[nodiscard]] double height(const Vec3& x) const { return dot(normal, x - point); }
};

/// The occluder as the viewpoint sees it. A polygon is its own silhouette and its only front face.
struct Outline {
  Loop silhouette;
  std::vector<Loop> front;  ///< faces turned to the viewpoint
};

/// The direction in which a point is seen.
[[nodiscard]] Vec3 sight(const Scene& scene, const Vec3& point);

/// Whether a face of a polytope is turned to the viewpoint. A face seen edge-on is not.
[[nodiscard]] bool is_front(const Scene& scene, const Loop& face);

/// REQUIRES: a polygon, or a polytope with a front face.
[[nodiscard]] Outline outline_of(const Scene& scene);

/// The farthest vertex of the silhouette; on a tie the lowest index.
[[nodiscard]] std::size_t farthest_vertex(const Scene& scene, const Outline& outline);

/// A side plane for each edge of the silhouette, in order, and then the near planes: one for `farthest`, one for each front
/// face for `surface`. An edge that is seen as a point has a normal of zero.
[[nodiscard]] std::vector<SketchPlane> sketch(const Scene& scene, const Outline& outline);

}  // namespace occlude::fuzz
