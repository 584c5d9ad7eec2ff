// SPDX-License-Identifier: MIT
// Cameras that are placed by matrices: they look along their -z axis, with their y axis upwards.
#pragma once

#include <glm/mat4x4.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "occlude/render/camera_path.h"

namespace occlude::render {

/// The numbers of a matrix as a file has them: 16, or 12 of one whose last row, 0 0 0 1, is left out.
struct MatrixNumbers {
  std::vector<double> numbers;
  std::string place;  ///< for messages: the file, and where in it
};

/// Adds a keyframe for each matrix, which takes the camera's coordinates to those of the model. Without `order` the last row
/// tells it: it is 0 0 0 1, and what moves the camera is elsewhere. Throws InputError, with `remedy`, where it does not, and
/// for what places no camera.
void add_keyframes(CameraPath& path, std::span<const MatrixNumbers> matrices, std::optional<MatrixOrder> order,
                   std::string_view remedy);

/// Adds the keyframe of a camera. One that is level, as the `up` of the path tells, has no `up` of its own. Throws
/// InputError, with `place`, where numbers are not legal.
void add_keyframe(CameraPath& path, const glm::dmat4& pose, const std::string& place);

}  // namespace occlude::render
