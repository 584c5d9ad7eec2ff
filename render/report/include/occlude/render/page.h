// SPDX-License-Identifier: MIT
// What the HTML pages have in common: their style, and how they write text and numbers.
#pragma once

#include <string>

namespace occlude::render {

/// A whole page, without scripts or outside addresses. Both texts are HTML.
[[nodiscard]] std::string page(const std::string& title, const std::string& body);

/// As text within HTML, or as an attribute.
[[nodiscard]] std::string escaped(const std::string& text);

/// A whole number with a comma at every thousand.
[[nodiscard]] std::string grouped(double value);

}  // namespace occlude::render
