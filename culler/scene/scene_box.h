// SPDX-License-Identifier: MIT
// Boxes as callers have them, made legal for the kernel.
#pragma once

#include "model/bounds.h"
#include "occlude/culler/box.h"
#include "occlude/kernel/types.h"
#include "scene/packed_edges.h"

namespace occlude::culler {

/// A box as scenes keep it, none by default.
struct SceneBox {
  kernel::Aabb outer = empty_box();  ///< legal, unless there is none
  PackedEdges edges;

  /// A box that holds the given one; none if that reaches beyond 2^100 and so has no place. Throws std::invalid_argument for
  /// a box with a fault().
  [[nodiscard]] static SceneBox of(const Box& box);
};

/// Whether there is such a box.
[[nodiscard]] inline bool is_some(const kernel::Aabb& outer) { return outer.min.x <= outer.max.x; }

}  // namespace occlude::culler
