// SPDX-License-Identifier: MIT
// Flights round and through a model.
#pragma once

#include <optional>

#include "occlude/culler/executor.h"
#include "occlude/render/camera_path.h"
#include "place.h"

namespace occlude::render {

/// A path once round the model, then in by its largest openings to what is most enclosed, and out again. None if there is
/// nothing to fly into.
[[nodiscard]] std::optional<CameraPath> through_air(const Place& place, const culler::Checkpoint& checkpoint);

}  // namespace occlude::render
