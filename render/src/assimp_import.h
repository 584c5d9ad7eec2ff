// SPDX-License-Identifier: MIT
// Polygons from glTF, COLLADA, STL and whatever else the Assimp library reads.
#pragma once

#include <filesystem>
#include <string>

#include "occlude/culler/polygon_soup.h"

namespace occlude::render {

/// Every polygon of every mesh, once for each node that shows it; points and lines are left out. Coordinates and up
/// direction stay the file's own. Throws InputError as read_model does, naming the mesh and its face.
[[nodiscard]] culler::PolygonSoup read_with_assimp(const std::filesystem::path& file);

/// The limits within which the library works, in words.
[[nodiscard]] std::string import_limits();

}  // namespace occlude::render
