// SPDX-License-Identifier: MIT
// Untrusted JSON: bounded in size and depth; every error names its place.
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace occlude::render {

/// The text is not JSON, is nested too deeply, or repeats a key. `at` is the byte at which this is found.
struct JsonError : std::runtime_error {
  JsonError(const char* what, std::size_t byte) : runtime_error(what), at(byte) {}
  std::size_t at;
};

/// Parses `text`, at most sixteen levels deep and without repeated keys in an object. NaN, Infinity and numbers outside the
/// range of double are accepted and returned as the strings "nan", "inf" and "-inf", so that the caller's error can name
/// the member.
[[nodiscard]] nlohmann::json parse_json(std::string_view text);

/// Parses the file. Throws InputError, naming the file and the line.
[[nodiscard]] nlohmann::json read_json(const std::filesystem::path& file);

/// The number that `value` holds, also as one of those strings; nothing if it is not a number.
[[nodiscard]] inline std::optional<double> number_of(const nlohmann::json& value) {
  if (value.is_number()) return value.get<double>();
  if (value == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (value == "inf") return std::numeric_limits<double>::infinity();
  if (value == "-inf") return -std::numeric_limits<double>::infinity();
  return std::nullopt;
}

}  // namespace occlude::render
