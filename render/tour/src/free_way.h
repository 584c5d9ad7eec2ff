// SPDX-License-Identifier: MIT
// Whether the way of an eye is free.
#pragma once

#include <span>

#include "occlude/culler/polygon_soup.h"
#include "occlude/render/camera_path.h"

namespace occlude::render {

/// Whether every triangle of the model is at least `clearance` from the straight lines between the eyes of consecutive
/// keyframes. Distances are rounded, but that a line meets no triangle is decided exactly. REQUIRES: legal coordinates, at
/// least one keyframe, clearance > 0.
[[nodiscard]] bool is_free_way(culler::SoupView model, std::span<const CameraPath::Keyframe> way, double clearance);

}  // namespace occlude::render
