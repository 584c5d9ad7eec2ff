// SPDX-License-Identifier: MIT
// Places boxes where the answer is hard: at a chosen feature of the frustum, on a chosen side of it.
#pragma once

#include <optional>

#include "contact.h"
#include "frames.h"
#include "occlude/fuzz/random.h"
#include "scene.h"

namespace occlude::fuzz {

struct Placement {
  Feature feature = Feature::any;
  bool is_lattice = true;          ///< exact: all numbers stay integers, and the scene is scaled up to make room
  int flat_axes = 0;               ///< the number of axes along which the box has no extent
  std::optional<FrameKind> frame;  ///< for an oriented box; empty for an axis-aligned one
};

/// Places a box. 40 % are in the frustum and touch the feature from within. 10 % are the same but stick out a little. 15 %
/// touch the feature from outside. 35 % are the same but slightly apart. On a lattice the viewpoint and the occluder are
/// scaled.
[[nodiscard]] Box place_box(Random& random, Scene& scene, const Placement& placement);

/// Places a box as place_box() does, but aims 40 % of the boxes at the other kind of near plane. Such boxes are between the
/// two near planes, or at rays that do not meet the near plane of the scene.
[[nodiscard]] Box place_box_for_other_near(Random& random, Scene& scene, const Placement& placement);

/// Places an edge of the box across an edge of the frustum. Both edges are in a plane with the box on one side and the
/// frustum on the other. The two touch in one point, overlap, or are slightly apart. When they are apart, perhaps no plane
/// of the frustum or of the box separates them.
[[nodiscard]] Box place_box_across(Random& random, Scene& scene, const Placement& placement);

/// Places an axis-aligned box as place_box() does. Half of the boxes then take another coordinate from a vertex.
[[nodiscard]] Box place_box_at_vertices(Random& random, Scene& scene, const Placement& placement);

/// Places a box around the eye. It may reach the near plane or not.
[[nodiscard]] Box place_box_about_eye(Random& random, Scene& scene, const Placement& placement);

}  // namespace occlude::fuzz
