// SPDX-License-Identifier: MIT
// Polygons from Wavefront OBJ files.
#pragma once

#include <filesystem>

#include "occlude/culler/polygon_soup.h"

namespace occlude::render {

/// Takes the statements `v` and `f` and ignores all others. Our own reader, because tinyobjloader 2.0 rounds every second
/// coordinate wrongly, cuts polygons down to their number of sides modulo 256 and takes what is not a number for 0.
/// Throws InputError as read_model does, naming the line.
[[nodiscard]] culler::PolygonSoup read_obj(const std::filesystem::path& file);

}  // namespace occlude::render
