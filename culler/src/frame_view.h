// SPDX-License-Identifier: MIT
// What a frame makes of its camera, once. Reading order: 12.
#pragma once

#include <span>
#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

struct FrameView {
  /// For a model no point of which is farther than `reach` from the eye, in the sum of the axes. REQUIRES: the camera has no
  /// fault().
  FrameView(const Camera& of, double reach);
  /// Of no model.
  FrameView() : FrameView(Camera{}, 0) {}

  /// As append_view_frustum().
  void append_half_spaces(std::vector<HalfSpace>& planes) const;
  /// Whether the renderer may clip something of the vertices' convex hull at its near plane: then it must not occlude.
  [[nodiscard]] bool may_clip(std::span<const kernel::Vec3> vertices) const;

  Camera camera;
  double depth;  ///< as given
  Camera::Axes axes;
  kernel::Viewpoint viewpoint;
  double half_height;  ///< of the picture: where it is 1 away along the line of sight, or, of parallel rays, anywhere
  double near;         ///< so far along it: what is beyond the renderer clips nowhere, whatever it rounds
};

}  // namespace occlude::culler
