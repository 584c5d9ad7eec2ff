// SPDX-License-Identifier: MIT
#include "occlude/render/json_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include "occlude/render/errors.h"
#include "occlude/render/input_file.h"
#include "occlude/render/input_limits.h"

namespace occlude::render {
namespace {

using Json = nlohmann::json;

/// More than our formats need (a witness of a region has two levels for each of its planes), and far less than would
/// overflow the stack of a recursive parser.
constexpr std::size_t kDeepest = 32;

/// The end of the string that begins at `start`.
std::size_t end_of_string(std::string_view text, std::size_t start) {
  std::size_t i = start + 1;
  while (i < text.size() && text[i] != '"') i += text[i] == '\\' ? 2 : 1;
  return std::min(i + 1, text.size());
}

/// The place where the nesting exceeds the limit. Checked before parsing.
std::optional<std::size_t> find_too_deep(std::string_view text) {
  std::size_t depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') i = end_of_string(text, i) - 1;
    if (c == '[' || c == '{') ++depth;
    if ((c == ']' || c == '}') && depth > 0) --depth;
    if (depth > kDeepest) return i;
  }
  return std::nullopt;
}

/// The value of the JSON string `quoted`.
std::string unquoted(std::string_view quoted) {
  if (quoted.find('\\') != quoted.npos) return Json::parse(quoted).get<std::string>();
  return std::string(quoted.substr(1, quoted.size() - 2));
}

/// The place of a repeated key in an object; it would be unclear which value counts. REQUIRES: the text is JSON except for
/// special numbers.
std::optional<std::size_t> find_repeated_key(std::string_view text) {
  std::vector<std::set<std::string>> objects;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '{') objects.emplace_back();
    if (text[i] == '}') objects.pop_back();
    if (text[i] != '"') continue;
    const std::string_view word = text.substr(i, end_of_string(text, i) - i);
    const std::size_t behind = text.find_first_not_of(" \t\r\n", i + word.size());
    const bool is_key = behind != text.npos && text[behind] == ':';
    if (is_key && !objects.back().insert(unquoted(word)).second) return i;
    i += word.size() - 1;
  }
  return std::nullopt;
}

/// The string that stands for a number outside JSON: NaN, Infinity, or a number too large for a double.
std::string_view quoted(double value) { return std::isnan(value) ? "\"nan\"" : value > 0 ? "\"inf\"" : "\"-inf\""; }

/// Replaces those numbers by quoted strings. Calls on_piece(piece, place, is_copy) with each piece of the result and its
/// place in `text`. Strings are copied.
template <class OnPiece>
void quote_special_numbers(std::string_view text, OnPiece&& on_piece) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t start = i;
    if (text[i] == '"') {
      i = end_of_string(text, start);
      on_piece(text.substr(start, i - start), start, true);
    } else if (i = std::min(text.find_first_of(",[]{} \t\r\n:\"", i), text.size()); i == start) {
      on_piece(text.substr(i++, 1), start, true);
    } else {
      const std::string word(text.substr(start, i - start));
      char* end = nullptr;
      const double value = std::strtod(word.c_str(), &end);
      if (std::isfinite(value)) end = nullptr;
      if (end != nullptr) on_piece(quoted(value), start, false);
      const std::size_t rest = end == nullptr ? start : start + static_cast<std::size_t>(end - word.c_str());
      on_piece(text.substr(rest, i - rest), rest, true);
    }
  }
}

/// The place in `text` that corresponds to byte `at` of its quoted form.
std::size_t place_before_quoting(std::string_view text, std::size_t at) {
  std::size_t done = 0, place = text.size();
  quote_special_numbers(text, [&](std::string_view piece, std::size_t start, bool is_copy) {
    if (done <= at && at < done + piece.size()) place = start + (is_copy ? at - done : 0);
    done += piece.size();
  });
  return place;
}

Json parse_with_special_numbers(std::string_view text) {
  std::string rewritten;
  rewritten.reserve(text.size());
  quote_special_numbers(text, [&](std::string_view piece, std::size_t, bool) { rewritten += piece; });
  try {
    return Json::parse(rewritten);
  } catch (const Json::parse_error& error) {
    const std::size_t at = error.byte - std::min<std::size_t>(error.byte, 1);  // counts from 1; 0 means none
    throw JsonError("not JSON", place_before_quoting(text, at));
  }
}

Json parse_any(std::string_view text) {
  try {
    return Json::parse(text);
  } catch (const Json::exception&) {
    return parse_with_special_numbers(text);
  }
}

}  // namespace

Json parse_json(std::string_view text) {
  if (const auto at = find_too_deep(text)) throw JsonError("nested too deeply", *at);
  Json value = parse_any(text);
  if (const auto at = find_repeated_key(text)) throw JsonError("repeated key in an object", *at);
  return value;
}

Json read_json(const std::filesystem::path& file) {
  const std::string text = read_input(file, kMostJson);
  try {
    return parse_json(text);
  } catch (const JsonError& error) {
    const std::string_view before = std::string_view(text).substr(0, error.at);
    const auto line = 1 + std::ranges::count(before, '\n');
    const std::size_t column = before.size() - (before.rfind('\n') + 1);  // npos + 1 is 0
    throw InputError(fmt::format("{}:{}: {}, near column {}", file.string(), line, error.what(), column + 1));
  }
}

}  // namespace occlude::render
