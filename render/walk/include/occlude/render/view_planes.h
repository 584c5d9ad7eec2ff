// SPDX-License-Identifier: MIT
// The half-spaces of a view, by their names.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "occlude/culler/camera.h"

namespace occlude::render {

/// In the order of append_view_frustum().
inline constexpr std::array<const char*, 6> kViewPlanes{"left", "right", "bottom", "top", "near", "far"};

/// How many the view of a camera has.
[[nodiscard]] inline std::size_t view_planes_of(const culler::Camera& camera) {
  return std::isinf(camera.far_plane) ? kViewPlanes.size() - 1 : kViewPlanes.size();
}

/// Names one of CullResult::view. Of a frame that is held, those of its region follow the camera's own.
[[nodiscard]] inline std::string name_of_plane(std::size_t plane, const culler::Camera& camera) {
  const std::size_t own = view_planes_of(camera);
  return plane < own ? kViewPlanes.at(plane) : std::string("region's ") + kViewPlanes.at(plane - own);
}

}  // namespace occlude::render
