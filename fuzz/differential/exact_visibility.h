// SPDX-License-Identifier: MIT
// The oracle's exact visibility of a soup's triangles.
#pragma once

#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/culler/polygon_soup.h"

namespace occlude::fuzz {

/// Of each triangle of the soup, the fans one after another, whether it shows to the camera: within the half-spaces of
/// append_view_frustum(), which lie outside of the renderer's planes by more than its rounding.
[[nodiscard]] std::vector<bool> visible_triangles(const culler::PolygonSoup& soup, const culler::Camera& camera);

}  // namespace occlude::fuzz
