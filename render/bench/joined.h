// SPDX-License-Identifier: MIT
// Joined shadows with varied parameters: the size of the coarse picture, the size of the leaves of the tree, and the number
// of triangles that a frame may draw into the picture.
#pragma once

#include <cstdint>
#include <vector>

#include "setting.h"

namespace occlude::experiments {

struct JoinedPoint {
  int width, height;        ///< of the coarse picture, pixels
  std::uint32_t leaf;       ///< most polygons in a leaf
  double budget_ms;         ///< CoverOptions::ms
  double culled_share = 0;  ///< of the polygons in view
  double drawn = 0;         ///< polygons per frame
  double cull_ms = 0;       ///< per frame; median over the rounds of the mean over the frames
};

struct Joined {
  std::vector<JoinedPoint> pictures, leaves, budgets;
};

/// Each round walks through every point once, so that a change of the machine's speed affects all points.
[[nodiscard]] Joined measure_joined(const Subject& subject, const Options& options);

}  // namespace occlude::experiments
