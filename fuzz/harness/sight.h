// SPDX-License-Identifier: MIT
// What a camera surely sees, found without any shadow: by looking along single rays.
#pragma once

#include <cstddef>

#include "occlude/culler/camera.h"
#include "occlude/culler/polygon_soup.h"

namespace occlude::harness {

/// Whether some middle of a fan triangle of the polygon is in the picture and no other polygon is before it, both by far
/// more than rounding can err. `false` says nothing.
[[nodiscard]] bool is_surely_visible(const culler::PolygonSoup& soup, std::size_t polygon, const culler::Camera& camera);

}  // namespace occlude::harness
