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

/// Throws as read_input does for a file that cannot be opened or is too large. For libraries that open files themselves.
void require_readable(const std::filesystem::path& file, std::uint64_t most = kMostBytes);

/// The bytes of `file` that are neither zero nor blank. It is read in small pieces. Throws as read_input does.
[[nodiscard]] std::uint64_t content_of(const std::filesystem::path& file, std::uint64_t most = kMostBytes);

}  // namespace occlude::render
