// SPDX-License-Identifier: MIT
// One reader per format.
#pragma once

#include <filesystem>

#include "occlude/culler/polygon_soup.h"

namespace occlude::render {

// All throw InputError like read_model.

/// PLY, ascii and binary, elements and properties in any order. Uses x, y, z of element `vertex` and the list vertex_indices
/// (or vertex_index) of element `face`; skips everything else.
[[nodiscard]] culler::PolygonSoup read_ply(const std::filesystem::path& file);

/// Wavefront OBJ: the statements `v` and `f`; all others are ignored. We have our own reader because tinyobjloader 2.0
/// rounds every second coordinate wrongly, truncates polygons to their number of sides modulo 256, and reads invalid numbers
/// as 0. Errors name the line.
[[nodiscard]] culler::PolygonSoup read_obj(const std::filesystem::path& file);

/// glTF, COLLADA, STL and the other formats of the Assimp library: every polygon of every mesh, once for each node that uses
/// the mesh. Points and lines are skipped. Coordinates and up direction are those of the file. Errors name the mesh and the
/// face.
[[nodiscard]] culler::PolygonSoup read_with_assimp(const std::filesystem::path& file);

}  // namespace occlude::render
