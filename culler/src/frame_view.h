// SPDX-License-Identifier: MIT
// What a frame computes from its camera once. Reading order: 11.
#pragma once

#include <span>
#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

struct FrameView {
  /// For a model with no point farther than `reach` from the eye, in the sum of the axes. REQUIRES: the camera has no
  /// fault().
  FrameView(const Camera& of, double reach);
  /// For no model.
  FrameView() : FrameView(Camera{}, 0) {}

  /// Does what append_view_frustum() does.
  void append_half_spaces(std::vector<HalfSpace>& planes) const;
  /// Whether the renderer may clip something of the convex hull of the vertices at its near plane. Such a thing must not
  /// occlude.
  [[nodiscard]] bool may_clip(std::span<const kernel::Vec3> vertices) const;

  Camera camera;
  double depth;  ///< the `reach` given
  Camera::Axes axes;
  kernel::Viewpoint viewpoint;
  double half_height;  ///< of the picture at a distance of 1 along the line of sight; with parallel rays, anywhere
  double near;         ///< the renderer clips nothing that is farther along the line of sight, however it rounds
};

}  // namespace occlude::culler
