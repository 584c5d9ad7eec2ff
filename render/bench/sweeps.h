// SPDX-License-Identifier: MIT
// The two numbers of the preprocess, varied: how many regions, and the least angle of what they list.
#pragma once

#include <cstddef>
#include <vector>

#include "occlude/culler/occluder_grid.h"
#include "setting.h"

namespace occlude::experiments {

struct SweepPoint {
  culler::OccluderGrid::Config grid;
  std::size_t entries = 0;  ///< of all lists
  double listed = 0;        ///< potential occluders of the eye's region, mean over the frames
  double culled_share = 0;  ///< of the polygons in view
  double preprocess_s = 0;  ///< tree, occluders and lists; median over the rounds
  double cull_ms = 0;       ///< a frame; median over the rounds of the mean over the frames
  double cull_ratio = 1;    ///< to the default grid's within a round; median over the rounds
};

struct Sweeps {
  std::vector<SweepPoint> regions, threshold;
};

/// In every round each grid is built and walked through once, so that whatever slows the machine slows all alike.
[[nodiscard]] Sweeps measure_sweeps(const Subject& subject, const Options& options);

}  // namespace occlude::experiments
