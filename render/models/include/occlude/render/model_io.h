// SPDX-License-Identifier: MIT
// Models in and out.
#pragma once

#include <filesystem>
#include <string>

#include "occlude/culler/polygon_soup.h"
#include "occlude/render/output_file.h"

namespace occlude::render {

/// Reads a model as polygon soup; polygons keep their sides. PLY and OBJ keep double precision; every other format the
/// Assimp library knows (glTF, COLLADA, STL, ...) comes in its single precision.
/// That library works in a child process, whose end, whatever its cause, is the end of the child alone.
/// Throws InputError with file and place for: a file that cannot be read or parsed, a coordinate that is not finite or
/// outside {0} or [2^-100, 2^100] in magnitude, an index out of range, a polygon of fewer than three vertices, no polygons.
[[nodiscard]] culler::PolygonSoup read_model(const std::filesystem::path& file);

/// The limits within which the import library works, in words.
[[nodiscard]] std::string import_limits();

/// Writes binary little-endian PLY with double coordinates and list uchar/uint32 faces; `comments` become header comments.
/// The caller commits the file. Throws Interrupted on Ctrl-C.
void write_ply(OutputFile& file, const culler::PolygonSoup& soup, const std::string& comment);

}  // namespace occlude::render
