// SPDX-License-Identifier: MIT
// From model space to the clip space of the renderer, with reversed depth.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "occlude/culler/camera.h"

namespace occlude::render {

/// The box that holds all vertices.
struct Extent {
  glm::dvec3 min{0, 0, 0}, max{0, 0, 0};
};

/// Takes vectors relative to the eye to clip space: depth 1 at the near plane, 0 at the far plane or at infinity. Half the
/// values a float can take between 0 and 1 lie below 2^-63, so distant surfaces are told apart as well as near ones. An
/// orthographic view without a far plane gets one behind `model`. `shift` moves the picture, to the right and up, in halves
/// of its sides.
[[nodiscard]] glm::mat4 clip_from_eye_relative(const culler::Camera& camera, const Extent& model,
                                               const glm::dvec2& shift = {0, 0});

}  // namespace occlude::render
