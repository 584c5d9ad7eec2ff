// SPDX-License-Identifier: MIT
// What the HTML pages share: their style, and the format of text and numbers.
#pragma once

#include <string>

namespace occlude::render {

/// A complete page without scripts or external addresses. Both arguments are HTML.
[[nodiscard]] std::string page(const std::string& title, const std::string& body);

/// Escapes text for HTML content or an attribute.
[[nodiscard]] std::string escaped(const std::string& text);

/// Rounds to an integer, with commas between thousands.
[[nodiscard]] std::string grouped(double value);

}  // namespace occlude::render
