// SPDX-License-Identifier: MIT
// The files of render/report/page, and the charts library, as they were when the program was built.
#pragma once

#include <string_view>

namespace occlude::render {

/// The text of the file with this name. REQUIRES: there is one (CMakeLists.txt has the list).
[[nodiscard]] std::string_view page_file(std::string_view name);

}  // namespace occlude::render
