// SPDX-License-Identifier: MIT
#include "obj_lines.h"

#include <fmt/format.h>

#include <algorithm>

#include "occlude/render/errors.h"

namespace occlude::render::obj {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }

// Words and lines are short: a loop finds their ends sooner than the search functions of strings.

/// The length of what comes before the first character that `is_end` holds for.
template <class IsEnd>
std::size_t length_before(std::string_view text, const IsEnd& is_end) {
  return static_cast<std::size_t>(std::ranges::find_if(text, is_end) - text.begin());
}

}  // namespace

std::string_view next_word(std::string_view& text) {
  text.remove_prefix(length_before(text, [](char c) { return !is_blank(c); }));
  const std::string_view word = text.substr(0, length_before(text, is_blank));
  text.remove_prefix(word.size());
  return word;
}

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(length_before(text, [](char c) { return !is_blank(c); }));
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

Lines::Lines(const std::filesystem::path& file, std::string_view bytes) : file_(file), rest_(bytes) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";  // some editors write it at the start
  if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
}

std::string_view Lines::next() {
  line_ = next_line_;
  std::string_view part = take();
  if (!part.ends_with('\\')) return part;
  joined_.clear();
  while (part.ends_with('\\')) {
    part.remove_suffix(1);
    joined_.append(part).push_back(' ');
    part = take();
  }
  return joined_.append(part);
}

/// Lines end in LF, CR LF or CR.
std::string_view Lines::take() {
  const std::string_view line = rest_.substr(0, length_before(rest_, [](char c) { return c == '\n' || c == '\r'; }));
  rest_.remove_prefix(line.size());
  rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, rest_.size()));
  if (line.find('\0') != line.npos) {
    throw InputError(fmt::format("{}:{}: zero byte: this is not a text file", file_.string(), next_line_));
  }
  ++next_line_;
  return line;
}

}  // namespace occlude::render::obj
