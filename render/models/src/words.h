// SPDX-License-Identifier: MIT
// The words of a line.
#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

namespace occlude::render {

/// What stands between these characters.
[[nodiscard]] inline std::vector<std::string_view> words_of(std::string_view line, std::string_view between = " \t\r\n") {
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(between); at != line.npos;) {
    const std::size_t end = std::min(line.find_first_of(between, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(between, end);
  }
  return words;
}

}  // namespace occlude::render
