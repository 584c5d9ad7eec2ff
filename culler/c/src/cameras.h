// SPDX-License-Identifier: MIT
// Cameras of the caller, of either kind.
#pragma once

#include "occlude.h"
#include "occlude/culler/camera.h"

namespace occlude::c {

// All of these throw std::invalid_argument for structs that are not legal.

[[nodiscard]] culler::Camera to_camera(const occlude_look_at_camera* given);
[[nodiscard]] culler::MatrixCamera to_camera(const occlude_matrix_camera* given);
[[nodiscard]] culler::AheadOptions to_way(const occlude_ahead_options* given);

}  // namespace occlude::c
