// SPDX-License-Identifier: MIT
// What `occlude preprocess` stores.
#pragma once

#include <cstdint>
#include <filesystem>

#include "occlude/culler/culler.h"
#include "occlude/culler/preprocess.h"
#include "occlude/render/output_file.h"

namespace occlude::render {

/// The layout of the file, all numbers little-endian: "occlude preprocess\n"; the version, u32; CRC-32 of the model's
/// vertices, loops and their starts, u32 each; leaf size, bounds (0 AABB, 1 OBB) and shells (0, 1), u32 each; threshold and
/// regions, f64; then five arrays, each its length as u64 and its elements: order and left of the tree, u32, first, u64,
/// occluders, u32, and hidden, f32, of the lists; last the CRC-32 of all before it, u32.
inline constexpr std::uint32_t kPreprocessVersion = 1;

/// Writes what was found out about `soup`. The caller commits the file.
void write_preprocess(OutputFile& file, const culler::PolygonSoup& soup, const culler::Preprocess& preprocess);

/// Reads it back for the model it was made of. Throws InputError, naming the file, for what is no such file, another
/// version, a file that ends early or goes on too long, a wrong checksum, numbers that cannot be right, and another model.
/// Allocates no more than the file is long. What the arrays mean is checked by Culler.
[[nodiscard]] culler::Preprocess read_preprocess(const std::filesystem::path& file, const culler::PolygonSoup& soup);

}  // namespace occlude::render
