// SPDX-License-Identifier: MIT
// A table, for a terminal and for a page.
#pragma once

#include <string>
#include <vector>

namespace occlude::experiments {

struct Table {
  std::string title;
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;  ///< as long as the head; the first cell names the row
  std::vector<std::string> notes;              ///< what to read from it, a line each
};

[[nodiscard]] std::string text_of(const Table& table);
/// Without the title.
[[nodiscard]] std::string html_of(const Table& table);

}  // namespace occlude::experiments
