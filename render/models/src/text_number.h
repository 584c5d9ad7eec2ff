// SPDX-License-Identifier: MIT
// Numbers in text files, read the same in every locale.
#pragma once

#include <charconv>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace occlude::render {

/// The number that is all of `token`, correctly rounded; nothing if it is not one, or an integer that T cannot hold. A real
/// number that T cannot hold comes as T's largest value, which every range check of the readers refuses.
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
