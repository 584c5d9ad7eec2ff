// SPDX-License-Identifier: MIT
// What a frame asks of its camera before anything else.
#pragma once

#include <glm/vec3.hpp>
#include <stdexcept>
#include <string>

#include "base/rounding.h"
#include "occlude/culler/camera.h"

namespace occlude::culler {

/// Throws std::invalid_argument for a camera with a fault(), std::runtime_error while the processor does not round to
/// nearest.
template <class AnyCamera>
void require_sound(const AnyCamera& camera) {
  require_rounding();
  if (const std::string reason = fault(camera); !reason.empty()) throw std::invalid_argument("camera: " + reason);
}

[[nodiscard]] inline glm::dvec3 eye_of(const Camera& camera) { return camera.eye; }
[[nodiscard]] inline glm::dvec3 eye_of(const MatrixCamera& camera) { return camera.eye(); }

}  // namespace occlude::culler
