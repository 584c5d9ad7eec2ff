// SPDX-License-Identifier: MIT
// Boxes put where the answer is hard: on a chosen feature of the frustum, from a chosen side.
#pragma once

#include "occlude/fuzz/cases.h"
#include "occlude/fuzz/random.h"

namespace occlude::fuzz {

/// The part of the frustum that the box is put to.
enum class Feature { interior, face, ray, near, corner, any };

struct Placement {
  Feature feature = Feature::any;
  bool is_lattice = true;  ///< exact: everything stays an integer and the scene is scaled up to make room
  int flat_axes = 0;       ///< on so many axes min = max
};

/// Puts the box. A quarter or so each: in the frustum and touching the feature from within; the same, poking out a little;
/// touching from without; the same, short of touching. The viewpoint and the polygon are scaled on the lattice.
void place_box(Random& random, Case& scene, const Placement& placement);

/// Puts a box about the eye that reaches the near plane or not quite.
void place_box_about_eye(Random& random, Case& scene);

}  // namespace occlude::fuzz
