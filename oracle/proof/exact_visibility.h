// SPDX-License-Identifier: MIT
// Exact visibility of the triangles of a soup, by the oracle.
#pragma once

#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/culler/polygon_soup.h"

namespace occlude::proof {

/// For each triangle of the soup, fan after fan, whether it shows to the camera: whether no opaque ones hide it. The picture
/// is smaller than the camera's by 2^-40 of the depth of the model, so a triangle that shows in it certainly shows.
[[nodiscard]] std::vector<bool> visible_triangles(culler::SoupView soup, const culler::Camera& camera);

}  // namespace occlude::proof
