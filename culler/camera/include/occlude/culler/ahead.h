// SPDX-License-Identifier: MIT
// A camera whose frame holds for the way ahead. Reading order: 2.
#pragma once

#include <glm/vec3.hpp>

#include "occlude/culler/camera.h"

namespace occlude::culler {

/// How far an eye may leave its way, and a head may turn. The lengths are for somebody who walks, in metres.
struct AheadOptions {
  double aside = 0.1;       ///< model units, to both sides of the way, and before and after a way that is shorter
  double up = 0.05;         ///< model units, to both sides across that
  double turn_degrees = 0;  ///< by how much the camera may turn, about any axis; perspective only
};

/// A camera from the middle of the way that the eye takes in so many seconds, with all eyes near the way as its `eyes`. A
/// frame of it holds (View::holds_for()) for a camera with the same picture that is anywhere there, turned by up to
/// turn_degrees.
/// 1. The region is a box. One half-edge is half of the way, but no shorter than `aside`; the others have the lengths of the
///    options. Each is longer by as far as `camera.eyes` reach along it.
/// 2. The picture is wider, as far as a picture may be (fault()): 60 degrees and 16:9 that turn by 10 take tangents 1.48 and
///    1.64 times as large. The near plane is farther, because what hides must be drawn by a camera that is turned, and the
///    far plane, if there is one, is as much farther.
/// 3. A matrix becomes a camera with a picture around the matrix's. If a ray of that picture does not meet its near plane,
/// as
///    with oblique ones, a frame of the camera hides nothing.
/// 4. With parallel rays, the frame holds only if adding the way to eye and target leaves the line of sight the same to the
///    last bit, as where it runs along an axis.
/// Throws std::invalid_argument for a camera with a fault(), for parallel rays that are a matrix's, and for numbers of which
/// no camera can be made.
[[nodiscard]] Camera ahead(const Camera& camera, const glm::dvec3& velocity, double seconds,
                           const AheadOptions& options = {});
[[nodiscard]] Camera ahead(const MatrixCamera& camera, const glm::dvec3& velocity, double seconds,
                           const AheadOptions& options = {});

}  // namespace occlude::culler
