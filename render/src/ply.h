// SPDX-License-Identifier: MIT
// Polygons from PLY files: ascii and binary, any order of elements and properties, whatever else they carry skipped.
#pragma once

#include <filesystem>

#include "occlude/culler/polygon_soup.h"

namespace occlude::render {

/// Takes x, y, z of element `vertex` and the list vertex_indices (or vertex_index) of element `face`. Throws InputError as
/// read_model does.
[[nodiscard]] culler::PolygonSoup read_ply(const std::filesystem::path& file);

}  // namespace occlude::render
