// SPDX-License-Identifier: MIT
// The readers of the formats.
#pragma once

#include <filesystem>

#include "occlude/culler/polygon_soup.h"

namespace occlude::render {

// All throw InputError as read_model does.

/// Polygons from PLY files: ascii and binary, any order of elements and properties, whatever else they carry skipped. Takes
/// x, y, z of element `vertex` and the list vertex_indices (or vertex_index) of element `face`.
[[nodiscard]] culler::PolygonSoup read_ply(const std::filesystem::path& file);

/// Polygons from Wavefront OBJ files: the statements `v` and `f`; all others are ignored. Our own reader, because
/// tinyobjloader 2.0 rounds every second coordinate wrongly, cuts polygons down to their number of sides modulo 256 and
/// takes what is not a number for 0. The error names the line.
[[nodiscard]] culler::PolygonSoup read_obj(const std::filesystem::path& file);

/// Polygons from glTF, COLLADA, STL and whatever else the Assimp library reads: every polygon of every mesh, once for each
/// node that shows it; points and lines are left out. Coordinates and up direction stay the file's own. The error names the
/// mesh and its face.
[[nodiscard]] culler::PolygonSoup read_with_assimp(const std::filesystem::path& file);

}  // namespace occlude::render
