// SPDX-License-Identifier: MIT
// The results of a benchmark as a table, for a terminal or a page.
#pragma once

#include <string>
#include <vector>

namespace occlude::bench {

struct Table {
  std::string title;
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;  ///< each as long as the head; the first cell names the row
  std::vector<std::string> notes;              ///< remarks, a line each
};

[[nodiscard]] std::string text_of(const Table& table);

}  // namespace occlude::bench
