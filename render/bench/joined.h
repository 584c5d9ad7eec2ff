// SPDX-License-Identifier: MIT
// Joined shadows, with what they depend on varied: how fine the coarse picture is, how small the leaves of the tree are, and
// how many triangles a frame may draw into the picture.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "setting.h"

namespace occlude::experiments {

struct JoinedPoint {
  int width, height;        ///< of the coarse picture, pixels
  std::uint32_t leaf;       ///< most polygons of a leaf
  std::size_t triangles;    ///< of a frame, about: CullOptions::cover_triangles
  double culled_share = 0;  ///< of the polygons in view
  double drawn = 0;         ///< polygons a frame
  double cull_ms = 0;       ///< a frame; median over the rounds of the mean over the frames
};

struct Joined {
  std::vector<JoinedPoint> pictures, leaves, budgets;
};

/// In every round each point is walked through once, so that whatever slows the machine slows all alike.
[[nodiscard]] Joined measure_joined(const Subject& subject, const Options& options);

}  // namespace occlude::experiments
