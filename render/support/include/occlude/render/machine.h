// SPDX-License-Identifier: MIT
// Where a figure was measured.
#pragma once

#include <string>

namespace occlude::render {

/// As the processor calls itself.
[[nodiscard]] std::string processor_name();

/// What compiled this program.
[[nodiscard]] std::string compiler_name();

}  // namespace occlude::render
