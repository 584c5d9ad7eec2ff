// SPDX-License-Identifier: MIT
// Boxes put where the answer is hard: on a chosen feature of the frustum, from a chosen side.
#pragma once

#include <optional>

#include "contact.h"
#include "frames.h"
#include "occlude/fuzz/random.h"
#include "scene.h"

namespace occlude::fuzz {

struct Placement {
  Feature feature = Feature::any;
  bool is_lattice = true;          ///< exact: everything stays an integer and the scene is scaled up to make room
  int flat_axes = 0;               ///< the box has no extent along so many of its axes
  std::optional<FrameKind> frame;  ///< of an oriented box; none: axis-aligned
};

/// Puts a box. A quarter or so each: in the frustum and touching the feature from within; the same, poking out a little;
/// touching from without; the same, short of touching. The viewpoint and the occluder are scaled on the lattice.
[[nodiscard]] Box place_box(Random& random, Scene& scene, const Placement& placement);

/// Puts a box aimed at the other kind of near plane: between occluder and near plane, or at rays that are behind it.
[[nodiscard]] Box place_box_for_other_near(Random& random, Scene& scene, const Placement& placement);

/// Puts an edge of a box across an edge of the frustum, in a plane that has the box on one side and the frustum on the
/// other: touching in one point, a little apart, so that no plane of the frustum or of the box need separate them, or
/// overlapping.
[[nodiscard]] Box place_box_across(Random& random, Scene& scene, const Placement& placement);

/// Puts a corner of an axis-aligned box to a vertex, and perhaps others of its coordinates too to vertices'.
[[nodiscard]] Box place_box_at_vertices(Random& random, Scene& scene, const Placement& placement);

/// Puts a box about the eye that reaches the near plane or not quite.
[[nodiscard]] Box place_box_about_eye(Random& random, Scene& scene, const Placement& placement);

}  // namespace occlude::fuzz
