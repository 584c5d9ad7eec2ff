// SPDX-License-Identifier: MIT
// The oracle's exact visibility of a soup's triangles.
#pragma once

#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/culler/polygon_soup.h"

namespace occlude::fuzz {

/// Of each triangle of the soup, the fans one after another, whether it shows to the camera. The picture is a hair wider and
/// deeper than the camera's: what the renderer's rounding may let in is in it.
[[nodiscard]] std::vector<bool> visible_triangles(const culler::PolygonSoup& soup, const culler::Camera& camera);

}  // namespace occlude::fuzz
