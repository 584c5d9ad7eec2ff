// SPDX-License-Identifier: MIT
// Points of the frustum at which a box is placed.
#pragma once

#include <vector>

#include "occlude/fuzz/random.h"
#include "sketch.h"

namespace occlude::fuzz {

/// The feature of the frustum at which the box is placed.
enum class Feature {
  interior,
  face,       ///< a side plane
  ray,        ///< an edge through the eye
  near,       ///< a near plane
  near_edge,  ///< an edge of a near plane
  corner,     ///< a corner of a near plane
  vertex,     ///< a vertex of the occluder at the near plane, hit exactly even with real coordinates
  any,        ///< interior, face, ray, near or corner
  edge,       ///< ray or near_edge
  front,      ///< near, near_edge or corner
};

/// A point of the frustum, and the normals of the frustum's planes on which it lies.
struct Contact {
  Vec3 point;
  std::vector<Vec3> normals;
};

/// Chooses one of the features that `any`, `edge` and `front` stand for.
[[nodiscard]] Feature resolve(Random& random, Feature feature);

/// A random point of the feature. On a lattice the occluder is scaled about the eye so that the point has integer
/// coordinates. For a direction it is scaled about the origin.
[[nodiscard]] Contact make_contact(Random& random, Scene& scene, const Outline& outline, Feature feature, bool is_lattice);

}  // namespace occlude::fuzz
