// SPDX-License-Identifier: MIT
// From model space to clip space, with reversed depth.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "occlude/culler/camera.h"

namespace occlude::render {

/// The bounding box of all vertices.
struct Extent {
  glm::dvec3 min{0, 0, 0}, max{0, 0, 0};
};

/// Maps vectors relative to the eye to clip space: depth 1 at the near plane, 0 at the far plane or at infinity. Half of the
/// float values between 0 and 1 lie below 2^-63, so distant surfaces are resolved as well as near ones. An orthographic view
/// without a far plane gets one behind `model`. `shift` moves the picture right and up, in units of half its width and
/// height.
[[nodiscard]] glm::mat4 clip_from_eye_relative(const culler::Camera& camera, const Extent& model,
                                               const glm::dvec2& shift = {0, 0});

}  // namespace occlude::render
