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

/// Whether a real number that is out of range is too near to 0, and not too far from it. A negative exponent of no less than
/// the number of characters before it makes it less than 1.
[[nodiscard]] inline bool is_tiny(std::string_view token) {
  const std::size_t sign = token.find_first_of("eE") + 1;
  if (sign == 0 || sign == token.size() || token[sign] != '-') return false;
  std::size_t exponent = 0;
  const auto error = std::from_chars(token.data() + sign + 1, token.data() + token.size(), exponent).ec;
  return error == std::errc::result_out_of_range || exponent >= sign;
}

/// The value of `token`, correctly rounded; nothing if the token is not a number, or an integer out of T's range. A real
/// number out of T's range becomes 0, or T's largest value, which the range checks of the readers refuse.
template <class T>
[[nodiscard]] std::optional<T> parse_number(std::string_view token) {
  if (token.starts_with('+') && !token.starts_with("+-")) token.remove_prefix(1);
  T value{};
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (error == std::errc::invalid_argument || end != token.data() + token.size()) return std::nullopt;
  if (error == std::errc{}) return value;
  if (std::is_integral_v<T>) return std::nullopt;
  return is_tiny(token) ? T{0} : std::numeric_limits<T>::max();
}

}  // namespace occlude::render
