// SPDX-License-Identifier: MIT
#include "occlude/render/frame_table.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "occlude/render/errors.h"
#include "occlude/render/input_file.h"
#include "occlude/render/line_reader.h"

namespace occlude::render {
namespace {

std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells;
  if (line.ends_with('\r')) line.remove_suffix(1);
  for (;;) {
    const std::size_t comma = line.find(',');
    cells.emplace_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

/// A finite number; nothing if the cell is none.
std::optional<double> number(const std::string& cell) {
  double value = 0;
  const char* const end = cell.data() + cell.size();
  const auto [next, error] = std::from_chars(cell.data(), end, value);
  return error == std::errc() && next == end && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

bool is_frame(double number) { return number >= 0 && number <= 0x1p53 && number == std::floor(number); }

[[noreturn]] void fail(const LineReader& lines, const std::string& what) {
  throw InputError(fmt::format("{}:{}: {}", lines.name(), lines.number(), what));
}

}  // namespace

FrameTable::FrameTable(const std::filesystem::path& file) {
  require_readable(file);
  LineReader lines(file.string());
  std::string line;
  if (!lines.next(line)) throw InputError(file.string() + ": the file is empty");
  std::vector<std::vector<double>*> columns;
  for (const std::string& name : cells_of(line)) {
    const auto [place, is_new] = columns_.try_emplace(name);
    if (!is_new) fail(lines, "a column is named twice: " + name);
    columns.push_back(&place->second);
  }
  if (!columns_.contains("frame")) fail(lines, "no column \"frame\"");
  while (lines.next(line)) {
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() != columns.size()) fail(lines, fmt::format("expected {} numbers", columns.size()));
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::optional<double> value = number(cells[i]);
      if (!value) fail(lines, fmt::format("'{}' is not a number", cells[i]));
      if (*value < 0) fail(lines, fmt::format("'{}' is negative", cells[i]));
      columns[i]->push_back(*value);
    }
    const std::vector<double>& numbers = frames();
    if (!is_frame(numbers.back())) fail(lines, "the frame is not a whole number");
    if (numbers.size() > 1 && numbers[numbers.size() - 2] >= numbers.back()) fail(lines, "frames do not ascend");
  }
}

const std::vector<double>* FrameTable::column(const std::string& name) const {
  const auto found = columns_.find(name);
  return found == columns_.end() ? nullptr : &found->second;
}

}  // namespace occlude::render
