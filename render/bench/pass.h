// SPDX-License-Identifier: MIT
// The camera moves along its path, and every frame is culled; nothing is drawn.
#pragma once

#include <cstddef>
#include <functional>

#include "occlude/culler/culler.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/walk.h"

namespace occlude::experiments {

/// Means over the frames.
struct Pass {
  double drawn = 0;    ///< polygons
  double listed = 0;   ///< potential occluders of the eye's region
  double cull_ms = 0;  ///< processor time; one thread culls
};

using OnCulled = std::function<void(const culler::Camera& camera, const culler::CullResult& culled)>;

/// The frames that `walk` names, in one view, culled by `cull`. Throws InputError when there are none, Interrupted on
/// Ctrl-C.
[[nodiscard]] Pass pass_along(const culler::Culler& culler, const render::CameraPath& path, const render::WalkOptions& walk,
                              const culler::CullOptions& cull, const OnCulled& on_culled = {});

/// Polygons a frame drawn with view-frustum culling alone.
[[nodiscard]] double polygons_in_view(const culler::Culler& culler, const render::CameraPath& path,
                                      const render::WalkOptions& walk);

/// Of the polygons in view the share that was not drawn.
[[nodiscard]] inline double culled_share(double in_view, double drawn) { return in_view == 0 ? 0 : 1 - drawn / in_view; }

}  // namespace occlude::experiments
