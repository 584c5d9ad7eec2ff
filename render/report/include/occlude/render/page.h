// SPDX-License-Identifier: MIT
// What the pages share: their style, and pictures.
#pragma once

#include <string>

namespace occlude::render {

/// A complete page without scripts or external addresses. Both arguments are HTML.
[[nodiscard]] std::string page(const std::string& title, const std::string& body);

/// A PNG file inside a page, and what it shows.
[[nodiscard]] std::string picture_html(const std::string& png, const std::string& caption);

}  // namespace occlude::render
