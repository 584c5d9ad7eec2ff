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

/// A right-handed camera looking from `eye` to `target`, `up` towards the top of the picture.
struct Camera {
  glm::dvec3 eye{0, 0, 0};
  glm::dvec3 target{1, 0, 0};
  glm::dvec3 up{0, 0, 1};
  Projection projection = Projection::perspective;
  double fov_y_deg = 60;       ///< full vertical opening angle, perspective only
  double height = 100;         ///< full vertical extent in model units, orthographic only
  double aspect = 16.0 / 9.0;  ///< width over height of the picture
  double near = 0.1;           ///< distance of the near plane from the eye, model units
  double far = std::numeric_limits<double>::infinity();

  /// Orthonormal axes of the picture up to rounding: right, up, forward. Every direction there is of the line of sight is
  /// `forward`, which the kernel takes for a viewpoint.
  struct Axes {
    glm::dvec3 right, up, forward;
  };
  /// REQUIRES: target != eye and up not parallel to the line of sight.
  [[nodiscard]] Axes axes() const;
  /// From where shadows fall: the eye, or for orthographic cameras the line of sight, of length 1.
  /// REQUIRES: of an orthographic one as axes().
  [[nodiscard]] kernel::Viewpoint viewpoint() const;
};

/// A half-space {x : normal . x + offset >= 0}.
struct HalfSpace {
  glm::dvec3 normal{0, 0, 0};
  double offset = 0;
};

/// Appends the half-spaces whose intersection holds everything that a renderer in single precision can draw of a model no
/// point of which is farther than `depth` from the eye, in the sum of the axes: left, right, bottom, top, near and, where
/// the camera has one, far. Each lies outside of the camera's own by 2^-20 `depth`, and its numbers are legal for the
/// kernel. REQUIRES: the camera has no fault().
void append_view_frustum(const Camera& camera, double depth, std::vector<HalfSpace>& planes);

/// Why the camera cannot be used: a number that is not finite or out of the kernel's legal range, an eye on its target, up
/// along the line of sight, an opening outside of [0.001, 179] degrees, an aspect outside of [1/65536, 65536], near <= 0,
/// far <= near. Empty when it can.
[[nodiscard]] std::string fault(const Camera& camera);

}  // namespace occlude::culler
