// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "occlude/render/page.h"
#include "tables.h"

namespace occlude::experiments {
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

std::string html_row(const Row& row, const char* tag) {
  std::string html = "<tr>";
  for (const std::string& cell : row) html += fmt::format("<{0}>{1}</{0}>", tag, render::escaped(cell));
  return html + "</tr>";
}

}  // namespace

std::string text_of(const Table& table) {
  const std::vector<std::size_t> columns = widths(table);
  std::string text = table.title + "\n" + line(table.head, columns);
  for (const Row& row : table.rows) text += line(row, columns);
  for (const std::string& note : table.notes) text += note + "\n";
  return text;
}

std::string html_of(const Table& table) {
  std::string html = R"(<div class="wide"><table><thead>)" + html_row(table.head, "th") + "</thead><tbody>";
  for (const Row& row : table.rows) html += html_row(row, "td");
  html += "</tbody></table></div>";
  for (const std::string& note : table.notes) html += R"(<p class="soft">)" + render::escaped(note) + "</p>";
  return html;
}

}  // namespace occlude::experiments
