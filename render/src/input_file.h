// SPDX-License-Identifier: MIT
// Input files, whole in memory.
#pragma once

#include <filesystem>
#include <string>

namespace occlude::render {

/// The bytes of `file`. Throws InputError unless it is a regular file that can be read.
[[nodiscard]] std::string read_input(const std::filesystem::path& file);

/// Throws what read_input would throw for a file that cannot be opened; for libraries that open files themselves.
void require_readable(const std::filesystem::path& file);

}  // namespace occlude::render
