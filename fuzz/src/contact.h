// SPDX-License-Identifier: MIT
// Points of the frustum that a box is put to.
#pragma once

#include <vector>

#include "occlude/fuzz/random.h"
#include "sketch.h"

namespace occlude::fuzz {

/// The part of the frustum that the box is put to.
enum class Feature {
  interior,
  face,       ///< a side plane
  ray,        ///< an edge through the eye
  near,       ///< a near plane
  near_edge,  ///< an edge of a near plane
  corner,     ///< a corner of a near plane
  vertex,     ///< a vertex of the occluder at the near plane, hit exactly though coordinates be real
  any,        ///< interior, face, ray, near or corner
  edge,       ///< ray or near_edge
  front,      ///< near, near_edge or corner
};

/// A point of the frustum, and the normals of the planes of the frustum on which it lies.
struct Contact {
  Vec3 point;
  std::vector<Vec3> normals;
};

/// One of the features that a collective name stands for.
[[nodiscard]] Feature resolve(Random& random, Feature feature);

/// A random point of the feature. On a lattice the occluder is scaled about the eye so that the point has integer
/// coordinates.
[[nodiscard]] Contact make_contact(Random& random, Scene& scene, const Outline& outline, Feature feature, bool is_lattice);

}  // namespace occlude::fuzz
