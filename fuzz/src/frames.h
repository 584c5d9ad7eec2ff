// SPDX-License-Identifier: MIT
// Directions for the edges of boxes.
#pragma once

#include <array>

#include "occlude/fuzz/random.h"
#include "sketch.h"

namespace occlude::fuzz {

/// Three vectors along the edges of a box. They may be dependent or zero.
using Frame = std::array<Vec3, 3>;

inline constexpr Frame kUnitFrame{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

enum class FrameKind {
  axes,       ///< along the coordinate axes, in any order and direction
  lattice,    ///< integers, orthogonal or skew
  dependent,  ///< integers in one plane, at least two of them not parallel
  parallel,   ///< integers, one to three of them along edges of the frustum
  large,      ///< large integers, so that products round
  real,       ///< reals, orthogonal up to rounding or skew
};

[[nodiscard]] Frame make_frame(Random& random, FrameKind kind, const Scene& scene, const Outline& outline);

/// Integer vectors, orthogonal or skew, that are not in one plane.
[[nodiscard]] Frame lattice_frame(Random& random);

}  // namespace occlude::fuzz
