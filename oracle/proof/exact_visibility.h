// SPDX-License-Identifier: MIT
// The oracle's exact visibility of a soup's triangles.
#pragma once

#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/culler/polygon_soup.h"

namespace occlude::proof {

/// Of each triangle of the soup, the fans one after another, whether it shows to the camera, in a picture narrower than the
/// camera's by a share of 2^-40: what shows in it surely shows.
[[nodiscard]] std::vector<bool> visible_triangles(const culler::PolygonSoup& soup, const culler::Camera& camera);

}  // namespace occlude::proof
