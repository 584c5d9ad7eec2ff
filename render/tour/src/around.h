// SPDX-License-Identifier: MIT
// Once round a model, outside of it.
#pragma once

#include <optional>
#include <vector>

#include "occlude/render/camera_path.h"
#include "place.h"
#include "poses.h"

namespace occlude::render {

/// Poses once round the model from the direction with this yaw on, so far that all of it is in the picture.
[[nodiscard]] std::vector<Pose> round(const Place& place, double yaw);

/// A path once round the model. None if the eye would have no legal coordinates.
[[nodiscard]] std::optional<CameraPath> around(const Place& place);

}  // namespace occlude::render
