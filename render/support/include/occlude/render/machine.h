// SPDX-License-Identifier: MIT
// The machine on which a figure was measured.
#pragma once

#include <string>

namespace occlude::render {

/// The processor's own name for itself.
[[nodiscard]] std::string processor_name();

/// The compiler of this program.
[[nodiscard]] std::string compiler_name();

}  // namespace occlude::render
