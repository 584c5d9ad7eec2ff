// SPDX-License-Identifier: MIT
#include "occlude/render/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace occlude::render {
namespace {

/// For what is not known.
constexpr const char* kNone = "-";

std::string shown(const Cell& cell, const Column& column) {
  if (cell.is_null()) return kNone;
  if (cell.is_object()) return cell.at("text");
  if (cell.is_array()) {
    std::string sides;
    for (const Cell& side : cell) sides += (sides.empty() ? "" : "x") + side.dump();
    return sides;
  }
  return cell.is_number() ? column.format(cell.get<double>()) : cell.get<std::string>();
}

/// Without what is for programs alone.
Table for_people(const Table& table) {
  Table result{table.title, {}, std::vector<std::vector<Cell>>(table.rows.size()), table.notes};
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    if (table.columns[k].head.empty()) continue;
    result.columns.push_back(table.columns[k]);
    for (std::size_t i = 0; i < table.rows.size(); ++i) result.rows[i].push_back(table.rows[i][k]);
  }
  return result;
}

/// The first cell is left-aligned, the others right-aligned.
std::string aligned(const std::string& text, std::size_t width, bool is_first, const std::string& painted) {
  const std::string padding(width - text.size(), ' ');
  return is_first ? painted + padding : "  " + padding + painted;
}

/// The line without blanks at its end.
std::string line_of(std::string row) { return row.erase(row.find_last_not_of(' ') + 1) + "\n"; }

std::string html_cell(const Cell& cell, const Column& column) {
  const std::string text = shown(cell, column);
  if (text == kNone) return "&ndash;";
  return cell.is_object() ? fmt::format(R"(<a href="{}">{}</a>)", escaped(cell.at("address")), escaped(text))
                          : escaped(text);
}

}  // namespace

Cell linked(const std::string& text, const std::string& address) { return {{"text", text}, {"address", address}}; }

std::string text_of(const Table& table, const Paint& paint) {
  const auto [title, columns, rows, notes] = for_people(table);
  std::vector<std::size_t> widths;
  std::string text = title.empty() ? "" : title + "\n", head;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    widths.push_back(columns[k].head.size());
    for (const auto& row : rows) widths[k] = std::max(widths[k], shown(row[k], columns[k]).size());
    head += aligned(columns[k].head, widths[k], k == 0, columns[k].head);
  }
  text += line_of(head);
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const std::string cell = shown(row[k], columns[k]);
      const std::optional<Colour> colour = columns[k].colour ? columns[k].colour(cell) : std::nullopt;
      line += aligned(cell, widths[k], k == 0, colour ? paint(*colour, cell) : cell);
    }
    text += line_of(line);
  }
  for (const std::string& note : notes) text += note + "\n";
  return text;
}

std::string html_of(const Table& table) {
  const auto [title, columns, rows, notes] = for_people(table);
  std::string html = R"(<div class="wide"><table><thead><tr>)";
  for (const Column& column : columns) html += "<th>" + escaped(column.head) + "</th>";
  html += "</tr></thead><tbody>\n";
  for (const auto& row : rows) {
    html += "<tr>";
    for (std::size_t k = 0; k < row.size(); ++k) html += "<td>" + html_cell(row[k], columns[k]) + "</td>";
    html += "</tr>\n";
  }
  html += "</tbody></table></div>";
  for (const std::string& note : notes) html += R"(<p class="soft">)" + escaped(note) + "</p>";
  return html;
}

std::string section(const std::string& title, const std::string& body) { return "<h2>" + escaped(title) + "</h2>" + body; }

std::string section(const Table& table) { return section(table.title, html_of(table)); }

nlohmann::ordered_json json_of(const Table& table) {
  auto rows = nlohmann::ordered_json::array();
  for (const auto& row : table.rows) {
    auto object = nlohmann::ordered_json::object();
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (!table.columns[k].key.empty()) object[table.columns[k].key] = row[k];
    }
    rows.push_back(std::move(object));
  }
  return rows;
}

}  // namespace occlude::render
