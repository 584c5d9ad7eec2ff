// SPDX-License-Identifier: MIT
// Section 7, measured: growth of time and memory with the number of polygons.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "setting.h"

namespace occlude::experiments {

/// A generated city of 20,000 polygons, repeated.
struct GrowthPoint {
  std::size_t polygons = 0;
  double in_view = 0, drawn = 0;  ///< polygons per frame
  double build_s = 0;             ///< tree, occluders and lists, on all processors; median over the rounds
  double cull_ms = 0;             ///< per frame, on one processor; median over the rounds of the mean over the frames
  double near_in_view = 0, near_cull_ms = 0;  ///< the same for views that end kNearSight from the eye
  /// Bytes per polygon beyond the model itself: at the peak of the build, and after it. See peak_memory.h.
  std::optional<double> peak_bytes, held_bytes;
};

/// Views that end here hold the same in all models. Model units.
inline constexpr double kNearSight = 150;

struct Growth {
  std::vector<GrowthPoint> points;
  /// Over the number of polygons; 1 is linear. Empty for fewer than two models.
  std::optional<double> build_exponent, cull_exponent, near_cull_exponent;
};

/// Each round generates, builds and walks through every model once.
[[nodiscard]] Growth measure_growth(const Options& options);

}  // namespace occlude::experiments
