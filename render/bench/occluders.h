// SPDX-License-Identifier: MIT
// A scene in which the drawn mesh hides, and others in which simplified occluders do.
#pragma once

#include <cstddef>
#include <vector>

#include "setting.h"

namespace occlude::experiments {

struct OccludersPoint {
  const char* chosen = "";     ///< how
  std::size_t triangles = 0;   ///< that may hide
  double hidden_share = 0;     ///< of the objects in view
  double cover_triangles = 0;  ///< drawn into the coarse picture, a frame
  double cull_ms = 0;          ///< a frame; median over the rounds of the mean over the frames
  double cull_ratio = 0;       ///< to the drawn mesh, median over the rounds
};

struct Occluders {
  std::size_t objects = 0;  ///< the leaves of a tree of the model, of up to 16 polygons
  std::vector<OccludersPoint> points;
};

/// Each round walks through every scene once, so that a change of the machine's speed affects all of them. Occluders are
/// chosen along the path (CameraPath::views()), with inner boxes and without, and with a finer picture than all others have.
[[nodiscard]] Occluders measure_occluders(const Subject& subject, const Options& options);

}  // namespace occlude::experiments
