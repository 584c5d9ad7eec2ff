// SPDX-License-Identifier: MIT
#include "table.h"

#include <fmt/format.h>

#include <algorithm>

namespace occlude::bench {
namespace {

using Row = std::vector<std::string>;

std::vector<std::size_t> widths(const Table& table) {
  std::vector<std::size_t> widths;
  for (const std::string& cell : table.head) widths.push_back(cell.size());
  for (const Row& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  return widths;
}

/// The first cell is left-aligned, the others right-aligned.
std::string line(const Row& row, const std::vector<std::size_t>& widths) {
  std::string text = fmt::format("{:<{}}", row[0], widths[0]);
  for (std::size_t i = 1; i < row.size(); ++i) text += fmt::format("  {:>{}}", row[i], widths[i]);
  return text + "\n";
}

}  // namespace

std::string text_of(const Table& table) {
  const std::vector<std::size_t> columns = widths(table);
  std::string text = table.title + "\n" + line(table.head, columns);
  for (const Row& row : table.rows) text += line(row, columns);
  for (const std::string& note : table.notes) text += note + "\n";
  return text;
}

}  // namespace occlude::bench
