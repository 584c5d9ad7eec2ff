// SPDX-License-Identifier: MIT
// The camera of one frame and the planes of its view frustum. Reading order: 2.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <limits>
#include <string>
#include <vector>

#include "occlude/kernel/types.h"

namespace occlude::culler {

enum class Projection { perspective, orthographic };

/// A right-handed camera that looks from `eye` to `target`, with `up` towards the top of the picture. Positions and lengths
/// are in model units. `up` need be neither a unit vector nor perpendicular to the line of sight.
struct Camera {
  glm::dvec3 eye{0, 0, 0};
  glm::dvec3 target{1, 0, 0};
  glm::dvec3 up{0, 0, 1};
  Projection projection = Projection::perspective;
  double fov_y_deg = 60;                                 ///< full vertical opening angle, perspective only
  double height = 100;                                   ///< full vertical extent in model units, orthographic only
  double aspect = 16.0 / 9.0;                            ///< width over height of the picture
  double near = 0.1;                                     ///< distance of the near plane from the eye, model units
  double far = std::numeric_limits<double>::infinity();  ///< as `near`; infinite: no far plane

  /// The axes of the picture, orthonormal up to rounding. `forward` is the line of sight. Its coordinates are legal for the
  /// kernel.
  struct Axes {
    glm::dvec3 right, up, forward;
  };
  /// REQUIRES: the camera has no fault().
  [[nodiscard]] Axes axes() const;
  /// The viewpoint of the shadows: the eye of a perspective camera, axes().forward of an orthographic one.
  /// REQUIRES: the camera has no fault().
  [[nodiscard]] kernel::Viewpoint viewpoint() const;
};

/// A half-space {x : normal . x + offset >= 0}. `normal` need not be a unit vector.
struct HalfSpace {
  glm::dvec3 normal{0, 0, 0};
  double offset = 0;
};

/// Appends the half-spaces of the view frustum: left, right, bottom, top, near and, if the camera has one, far.
/// 1. Their intersection holds everything that a renderer in single precision can draw of a model within `depth` of the eye.
///    `depth` is an L1 distance, |dx| + |dy| + |dz|, in model units.
/// 2. Each plane lies at least 2^-20 `depth` outside the camera's own plane.
/// 3. All their numbers are legal for the kernel. A normal has length 1 or less, up to rounding.
/// REQUIRES: the camera has no fault().
void append_view_frustum(const Camera& camera, double depth, std::vector<HalfSpace>& planes);

/// Why the camera cannot be used; empty if it can. All numbers are checked, whatever the projection. The faults are:
/// 1. a number that is not finite (`far` may be infinite) or is out of the kernel's legal range;
/// 2. an eye at its target, or an `up` of zero or within 1e-9 radians of the line of sight;
/// 3. fov_y_deg outside [0.001, 179], or aspect outside [1/65536, 65536];
/// 4. height <= 0, near <= 0 or far <= near.
[[nodiscard]] std::string fault(const Camera& camera);

}  // namespace occlude::culler
