// SPDX-License-Identifier: MIT
// The two parameters of the preprocess, varied: the number of regions, and the smallest solid angle that they list.
#pragma once

#include <cstddef>
#include <vector>

#include "frusta/occluder_lists.h"
#include "setting.h"

namespace occlude::experiments {

struct SweepPoint {
  culler::ListConfig lists;
  std::size_t entries = 0;  ///< of all lists
  double listed = 0;        ///< potential occluders in the list of the eye's region, mean over the frames
  double culled_share = 0;  ///< of the polygons in view
  double preprocess_s = 0;  ///< tree, occluders and lists; median over the rounds
  double cull_ms = 0;       ///< per frame; median over the rounds of the mean over the frames
  double cull_ratio = 1;    ///< to the default in the same round; median over the rounds
};

struct Sweeps {
  std::vector<SweepPoint> regions, threshold;
};

/// Each round prepares and walks every point once, so that a change of the machine's speed affects all points.
[[nodiscard]] Sweeps measure_sweeps(const Subject& subject, const Options& options);

}  // namespace occlude::experiments
