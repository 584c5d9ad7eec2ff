// SPDX-License-Identifier: MIT
// The oracle's exact visibility of a soup's polygons.
#pragma once

#include <span>
#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/culler/polygon_soup.h"

namespace occlude::fuzz {

/// Of each triangle of the soup, the fans one after another, whether it shows to the camera, whose view frustum
/// append_view_frustum() gives.
[[nodiscard]] std::vector<bool> visible_triangles(const culler::PolygonSoup& soup, const culler::Camera& camera,
                                                  std::span<const culler::HalfSpace> view);

}  // namespace occlude::fuzz
