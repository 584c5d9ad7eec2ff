// SPDX-License-Identifier: MIT
// The manual page of the program.
#pragma once

#include <string>

#include "command_text.h"

namespace occlude::cli {

/// In the language of man(7).
[[nodiscard]] std::string man_page(const CommandText& program);

}  // namespace occlude::cli
