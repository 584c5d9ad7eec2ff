// SPDX-License-Identifier: MIT
// One reader per format.
#pragma once

#include <filesystem>

#include "counted_files.h"
#include "occlude/render/model.h"

namespace occlude::render {

// All throw InputError like read_model, and read colours if these are asked for.

/// PLY, ascii and binary, elements and properties in any order. Uses x, y, z of element `vertex` and the list vertex_indices
/// (or vertex_index) of the elements `face` and `tristrips`, and red, green and blue of
/// vertices, or else of faces; skips everything else.
[[nodiscard]] Model read_ply(const std::filesystem::path& file, bool with_colours = false);

/// Wavefront OBJ: the statements `v` and `f`, and of materials whether they let light through, and Kd. We have our own
/// reader because tinyobjloader 2.0 rounds every second coordinate wrongly, truncates polygons to their number of sides
/// modulo 256, and reads invalid numbers as 0. Errors name the line.
[[nodiscard]] Model read_obj(const std::filesystem::path& file, bool with_colours = false);

/// glTF 2.0, as .gltf or .glb (1.0 by the Assimp library): every triangle of every mesh, once for each node of the scene
/// that shows it, where the file shows it at rest. Numbers of the file are doubles from the first on. Reads quantised,
/// sparse, compressed (Draco, meshopt) and instanced geometry, morph targets and skins; refuses what else it requires.
/// Buffers must be in the file, or in its folder. Errors name mesh, primitive and vertex. Colours are those of materials,
/// times the mean of a picture, and of vertices.
[[nodiscard]] Model read_gltf(const std::filesystem::path& file, bool with_colours = false);

/// COLLADA, STL and the other formats of the Assimp library: every polygon of every mesh, once for each node that uses
/// the mesh. Points and lines are skipped. Coordinates and up direction are those of the file. Errors name the mesh and the
/// face. Colours are those of materials.
[[nodiscard]] Model read_with_assimp(const std::filesystem::path& file, bool with_colours = false);

/// The same in the child process of an import (import_child.h).
[[nodiscard]] Model import_with_assimp(const std::filesystem::path& file, CountedFiles& files, bool with_colours);

}  // namespace occlude::render
