// SPDX-License-Identifier: MIT
#include "html_table.h"

#include <fmt/format.h>

#include "occlude/render/page.h"

namespace occlude::experiments {
namespace {

std::string html_row(const std::vector<std::string>& row, const char* tag) {
  std::string html = "<tr>";
  for (const std::string& cell : row) html += fmt::format("<{0}>{1}</{0}>", tag, render::escaped(cell));
  return html + "</tr>";
}

}  // namespace

std::string section(const std::string& title, const std::string& body) {
  return "<h2>" + render::escaped(title) + "</h2>" + body;
}

std::string html_of(const Table& table) {
  std::string html = R"(<div class="wide"><table><thead>)" + html_row(table.head, "th") + "</thead><tbody>";
  for (const auto& row : table.rows) html += html_row(row, "td");
  html += "</tbody></table></div>";
  for (const std::string& note : table.notes) html += R"(<p class="soft">)" + render::escaped(note) + "</p>";
  return html;
}

std::string section(const Table& table) { return section(table.title, html_of(table)); }

}  // namespace occlude::experiments
