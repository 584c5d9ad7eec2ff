// SPDX-License-Identifier: MIT
// Numbers in text files, independent of the locale.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace occlude::render {

/// Whether a number in decimal digits that is too large or too near to 0 for its type is below 1 in magnitude.
[[nodiscard]] inline bool is_below_one(std::string_view token) {
  const std::size_t end = std::min(token.find_first_of("eE"), token.size());
  const std::string_view digits = token.substr(0, end);
  std::string_view exponent = token.substr(std::min(end + 1, token.size()));
  if (exponent.starts_with('+')) exponent.remove_prefix(1);
  std::int64_t power = 0;
  if (std::from_chars(exponent.data(), exponent.data() + exponent.size(), power).ec == std::errc::result_out_of_range)
    return exponent.starts_with('-');
  // The power of ten of the first digit that is not 0.
  const std::size_t point = std::min(digits.find('.'), digits.size()), first = digits.find_first_of("123456789");
  const auto place = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first);
  return power < (place > 0 ? 1 - place : -place);
}

/// The value of `token`, correctly rounded; nothing if the token is not a number, or an integer out of T's range. A real
/// number out of T's range becomes T's largest value, which the range checks of the readers refuse, or the one nearest to 0,
/// which they take as 0.
template <class T>
[[nodiscard]] std::optional<T> parse_number(std::string_view token) {
  if (token.starts_with('+') && !token.starts_with("+-")) token.remove_prefix(1);
  T value{};
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (error == std::errc::invalid_argument || end != token.data() + token.size()) return std::nullopt;
  if (error == std::errc{}) return value;
  if (std::is_integral_v<T>) return std::nullopt;
  return is_below_one(token) ? std::numeric_limits<T>::denorm_min() : std::numeric_limits<T>::max();
}

}  // namespace occlude::render
