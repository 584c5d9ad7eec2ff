// SPDX-License-Identifier: MIT
// Numbers in text files, independent of the locale.
#pragma once

#include <charconv>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace occlude::render {

/// The value of `token`, correctly rounded; nothing if the token is not a number, or an integer out of T's range. A real
/// number out of T's range becomes T's largest value, which the range checks of the readers refuse.
template <class T>
[[nodiscard]] std::optional<T> parse_number(std::string_view token) {
  if (token.starts_with('+') && !token.starts_with("+-")) token.remove_prefix(1);
  T value{};
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (error == std::errc::invalid_argument || end != token.data() + token.size()) return std::nullopt;
  if (error == std::errc{}) return value;
  if (std::is_integral_v<T>) return std::nullopt;
  return std::numeric_limits<T>::max();
}

}  // namespace occlude::render
