// SPDX-License-Identifier: MIT
// The font of legends, as it was when the program was built.
#pragma once

#include <string_view>

namespace occlude::render {

/// The bytes of the font with this file name. REQUIRES: there is one (CMakeLists.txt has the list).
[[nodiscard]] std::string_view font_file(std::string_view name);

}  // namespace occlude::render
