// SPDX-License-Identifier: MIT
// JSON that others have written: bounded in size and depth, every error with its place.
#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace occlude::render {

/// What is not JSON, too deep, or says a thing twice; `at` is the byte of the text that shows it.
struct JsonError : std::runtime_error {
  JsonError(const char* what, std::size_t byte) : runtime_error(what), at(byte) {}
  std::size_t at;
};

/// The value that `text` is, at most sixteen levels deep and without a key twice in an object. Takes NaN, Infinity and
/// numbers beyond the doubles as well: as the strings "nan", "inf" and "-inf", so that whoever needs a number there can say
/// which.
[[nodiscard]] nlohmann::json parse_json(std::string_view text);

/// The value that the file holds. Throws InputError, naming the file and the line.
[[nodiscard]] nlohmann::json read_json(const std::filesystem::path& file);

/// The number, also of one of those strings; nothing for what is no number.
[[nodiscard]] std::optional<double> number_of(const nlohmann::json& value);

}  // namespace occlude::render
