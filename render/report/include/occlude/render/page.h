// SPDX-License-Identifier: MIT
// What the pages share: their style.
#pragma once

#include <string>

namespace occlude::render {

/// A complete page without scripts or external addresses. Both arguments are HTML.
[[nodiscard]] std::string page(const std::string& title, const std::string& body);

}  // namespace occlude::render
