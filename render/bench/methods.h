// SPDX-License-Identifier: MIT
// Table 2 with every method side by side: view-frustum culling alone, the paper's frusta, joined shadows, and the ideal:
// drawing only visible polygons.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "occlude/render/walk.h"
#include "setting.h"

namespace occlude::experiments {

/// Means per frame.
struct MethodRow {
  std::string name;
  double drawn = 0;                     ///< polygons
  std::optional<double> hidden_culled;  ///< share of the hidden polygons in view; empty unless frames are drawn
  double cull_ms = 0, worst_cull_ms = 0;
  std::optional<double> frame_ms;
};

using Methods = std::vector<MethodRow>;

/// `walked` is the walk of table 2, with `options.walk.cull.method`. The other method walks the same frames.
[[nodiscard]] Methods measure_methods(const Subject& subject, const Options& options, const render::WalkResult& walked);

}  // namespace occlude::experiments
