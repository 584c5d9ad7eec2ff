// SPDX-License-Identifier: MIT
// Finds what a camera certainly sees, without any shadow, by looking along single rays.
#pragma once

#include <cstddef>

#include "occlude/culler/camera.h"
#include "occlude/culler/polygon_soup.h"

namespace occlude::harness {

/// Whether the middle of some fan triangle of the polygon is in the picture and no other polygon is in front of it, both by
/// far more than the rounding error. `false` means that nothing is known.
[[nodiscard]] bool is_surely_visible(culler::SoupView soup, std::size_t polygon, const culler::Camera& camera);

}  // namespace occlude::harness
