// SPDX-License-Identifier: MIT
// Culls every frame along a path without drawing.
#pragma once

#include <functional>

#include "occlude/culler/culler.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/walk.h"

namespace occlude::experiments {

/// Means over the frames.
struct Pass {
  double drawn = 0;     ///< polygons
  double listed = 0;    ///< potential occluders in the list of the eye's region
  double cull_ms = 0;   ///< processor time of the culling thread
  double clock_ms = 0;  ///< the same by the clock
};

using OnCulled = std::function<void(const culler::Camera& camera, const culler::CullResult& culled)>;

/// Culls the frames that `walk` selects, in one view, with `cull`. Throws InputError if there are none, Interrupted on
/// Ctrl-C.
[[nodiscard]] Pass pass_along(const culler::Culler& culler, const render::CameraPath& path, const render::WalkOptions& walk,
                              const culler::CullOptions& cull, const OnCulled& on_culled = {});

/// Polygons drawn per frame with view-frustum culling alone.
[[nodiscard]] double polygons_in_view(const culler::Culler& culler, const render::CameraPath& path,
                                      const render::WalkOptions& walk);

/// The share of the polygons in view that was not drawn.
[[nodiscard]] inline double culled_share(double in_view, double drawn) { return in_view == 0 ? 0 : 1 - drawn / in_view; }

}  // namespace occlude::experiments
