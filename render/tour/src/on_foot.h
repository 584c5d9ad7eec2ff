// SPDX-License-Identifier: MIT
// Walks through a model.
#pragma once

#include <optional>

#include "occlude/culler/executor.h"
#include "occlude/render/camera_path.h"
#include "place.h"

namespace occlude::render {

/// A walk through what of the model is most enclosed by walls: streets and rooms rather than roofs and plains. None if there
/// is no floor, or too little room on it. With `is_choosy` also if there is little around the walk, or it is inside of
/// something closed whose sides turn outwards.
[[nodiscard]] std::optional<CameraPath> on_foot(const Place& place, bool is_choosy, const culler::Checkpoint& checkpoint);

}  // namespace occlude::render
