// SPDX-License-Identifier: MIT
// The file of `occlude preprocess`.
#pragma once

#include <cstdint>
#include <filesystem>

#include "occlude/culler/culler.h"
#include "occlude/culler/preprocess.h"
#include "occlude/render/output_file.h"

namespace occlude::render {

/// The layout of the file, all numbers little-endian: "occlude preprocess\n"; the version, u32; CRC-32 of the model's
/// vertices, loops and their starts, u32 each; leaf size, bounds (0 AABB, 1 OBB), shells (0, 1) and the kind of the regions
/// (0 grid, 1 tree), u32 each; threshold and number of regions, f64; then five arrays, each its length as u64 and its
/// elements: order and left of the tree, u32, first, u64, occluders, u32, and hidden, f32, of the lists; last the CRC-32 of
/// all before it, u32.
inline constexpr std::uint32_t kPreprocessVersion = 2;

/// Writes the preprocess of `soup`. The caller commits the file.
void write_preprocess(OutputFile& file, const culler::PolygonSoup& soup, const culler::Preprocess& preprocess);

/// Reads the preprocess of `soup`. Throws InputError, naming the file, if it is not such a file, has another version, is too
/// short or too long, has a wrong checksum or an invalid setting, or was made from another model. Allocates no more than
/// the size of the file. Culler checks the contents of the arrays.
[[nodiscard]] culler::Preprocess read_preprocess(const std::filesystem::path& file, const culler::PolygonSoup& soup);

}  // namespace occlude::render
