// SPDX-License-Identifier: MIT
// The colour a polygon has in pictures, from nothing but its plane.
#pragma once

#include <cstddef>

#include "occlude/culler/polygon_soup.h"
#include "occlude/render/image.h"

namespace occlude::render {

/// Level ground and gentle slopes are green-grey, steeper ones roof tiles, walls brick and stucco with one tone a plane; lit
/// by a sun in the south-west, both sides alike. The same on every machine.
[[nodiscard]] Rgba polygon_colour(const culler::PolygonSoup& soup, std::size_t polygon);

}  // namespace occlude::render
