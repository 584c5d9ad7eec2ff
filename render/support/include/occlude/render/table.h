// SPDX-License-Identifier: MIT
// A table: as text for a terminal, as HTML for a page, and as JSON for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "occlude/render/formats.h"
#include "occlude/render/paint.h"

namespace occlude::render {

struct Column {
  std::string head;                         ///< for people; a column without one is for programs alone
  std::string key = {};                     ///< for programs; a column without one is for people alone
  std::string (*format)(double) = grouped;  ///< how its numbers are written for people
  std::optional<Colour> (*colour)(const std::string& shown) = nullptr;  ///< of its cells on a terminal
};

/// A text, a number, an array of numbers such as a size, a linked(), or null for what is not known.
using Cell = nlohmann::ordered_json;

/// A text that leads elsewhere on a page.
[[nodiscard]] Cell linked(const std::string& text, const std::string& address);

/// Null if there is none.
template <class Value>
[[nodiscard]] Cell if_known(const std::optional<Value>& value) {
  return value ? Cell(*value) : Cell(nullptr);
}

struct Table {
  std::string title;  ///< may be empty
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;  ///< each as long as the columns; the first cell that is shown names the row
  std::vector<std::string> notes = {};  ///< remarks, a line each
};

/// The title, the table and its notes.
[[nodiscard]] std::string text_of(const Table& table, const Paint& paint = {});

/// The table and its notes.
[[nodiscard]] std::string html_of(const Table& table);

/// A heading, and what is below it.
[[nodiscard]] std::string section(const std::string& title, const std::string& body);
[[nodiscard]] std::string section(const Table& table);

/// An array with an object for each row.
[[nodiscard]] nlohmann::ordered_json json_of(const Table& table);

}  // namespace occlude::render
