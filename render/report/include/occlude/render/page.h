// SPDX-License-Identifier: MIT
// What the pages share: their style, and the format of text and numbers.
#pragma once

#include <optional>
#include <string>

namespace occlude::render {

/// A complete page without scripts or external addresses. Both arguments are HTML.
[[nodiscard]] std::string page(const std::string& title, const std::string& body);

/// Escapes text for HTML content or an attribute.
[[nodiscard]] std::string escaped(const std::string& text);

/// Rounds to an integer, with commas between thousands.
[[nodiscard]] std::string grouped(double value);

/// A share in percent, with one decimal.
[[nodiscard]] std::string percent(double share);

/// Frames per second at this many milliseconds a frame, or `none`.
[[nodiscard]] std::string fps(const std::optional<double>& ms, const char* none);

/// The change to this ratio in percent, with its sign, or `none`.
[[nodiscard]] std::string gain(const std::optional<double>& ratio, const char* none);

}  // namespace occlude::render
