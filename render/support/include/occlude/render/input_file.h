// SPDX-License-Identifier: MIT
// Input files, whole in memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "occlude/render/input_limits.h"

namespace occlude::render {

/// The bytes of `file`. Throws InputError unless it is a regular file that can be read, of no more than `most` bytes.
[[nodiscard]] std::string read_input(const std::filesystem::path& file, std::uint64_t most = kMostBytes);

/// Throws what read_input would throw for a file that cannot be opened or is too large; for libraries that open files
/// themselves. Returns its size.
std::uint64_t require_readable(const std::filesystem::path& file, std::uint64_t most = kMostBytes);

}  // namespace occlude::render
