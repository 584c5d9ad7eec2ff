// SPDX-License-Identifier: MIT
// Text and numbers as reports show them.
#pragma once

#include <optional>
#include <string>

namespace occlude::render {

/// Escapes text for HTML content or an attribute.
[[nodiscard]] std::string escaped(const std::string& text);

/// Rounds to an integer, with commas between thousands.
[[nodiscard]] std::string grouped(double value);

/// With so many digits after the point, and 0 without a sign.
[[nodiscard]] std::string rounded(double value, int digits);
template <int digits>
[[nodiscard]] std::string rounded(double value) {
  return rounded(value, digits);
}

/// Six digits, without those at the end that are 0.
[[nodiscard]] std::string short_of(double value);

/// A share in percent, with one decimal.
[[nodiscard]] std::string percent(double share);

/// Frames per second at this many milliseconds a frame, or `none`.
[[nodiscard]] std::string fps(const std::optional<double>& ms, const char* none);

/// The change to this ratio in percent, with its sign, or `none`.
[[nodiscard]] std::string gain(const std::optional<double>& ratio, const char* none);

}  // namespace occlude::render
