// SPDX-License-Identifier: MIT
// Reading and writing models.
#pragma once

#include <filesystem>
#include <string>

#include "occlude/culler/polygon_soup.h"
#include "occlude/render/model.h"
#include "occlude/render/output_file.h"

namespace occlude::render {

/// Reads a model. PLY, OBJ and glTF are read in double precision; other formats (COLLADA, STL, ...) are read by the Assimp
/// library, in its single precision.
/// Of a store (store.h) it is the model that the store was made of, and throws as read_store().
/// Assimp and the reader of glTF run in a child process, so their crashes do not end this process.
/// Throws InputError with file and place if the file cannot be read or parsed, a face uses a vertex with a coordinate that
/// is not finite or above 2^100 in magnitude, an index is out of range, or there is no polygon. Numbers nearer to 0 than
/// 2^-100 are 0, unless no coordinate is so large that this is a rounding error (2^-47), which is refused.
[[nodiscard]] Model read_model(const std::filesystem::path& file, const ReadOptions& options = {});

/// The limits of that child process, in words.
[[nodiscard]] std::string import_limits();

/// Writes binary little-endian PLY with double coordinates and lists of uint32 indices. Each line of `comment` becomes a
/// header comment. The caller commits the file. Throws Interrupted on Ctrl-C.
void write_ply(OutputFile& file, culler::SoupView soup, const std::string& comment);

}  // namespace occlude::render
