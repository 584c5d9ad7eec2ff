// SPDX-License-Identifier: MIT
// The near side of a shadow that begins at a single plane: `farthest`, or a given plane.
#pragma once

#include <optional>

#include "occlude/oracle/oracle.h"
#include "triangles.h"

namespace occlude::oracle::second {

/// The half-space (to - from) . (x - point) >= 0.
struct NearSide {
  Point from, to, point;
};

/// Empty for `surface`, where the shadow begins at the occluder. REQUIRES: `triangles` are those of the occluder.
[[nodiscard]] std::optional<NearSide> near_side(const Viewpoint& view, const Occluder& occluder, const Near& near,
                                                const Triangles& triangles);

[[nodiscard]] bool is_beyond(const NearSide& near, const ExactPoint& x);

}  // namespace occlude::oracle::second
