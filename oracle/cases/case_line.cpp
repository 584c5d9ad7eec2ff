// SPDX-License-Identifier: MIT
#include "cases/case_line.h"

#include <fmt/core.h>

#include "occlude/render/errors.h"
#include "occlude/render/json_text.h"
#include "occlude/render/line_reader.h"
#include "occlude/render/progress.h"

namespace occlude::cases {

nlohmann::json parse_object(std::string_view line) {
  try {
    nlohmann::json object = render::parse_json(line);
    if (!object.is_object()) throw LineError("not a JSON object");
    return object;
  } catch (const render::JsonError& error) {
    throw LineError(fmt::format("{}, near column {}", error.what(), error.at + 1));
  }
}

void for_each_case(const std::string& file, bool silence,
                   const std::function<void(std::size_t number, const nlohmann::json&)>& take) {
  render::LineReader lines(file);
  render::Progress progress("MB of cases", lines.size() >> 20U);
  bool has_case = false;
  for (std::string line; lines.next(line);) {
    if (!silence) progress.update(lines.read() >> 20U);
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    has_case = true;
    try {
      take(lines.number(), parse_object(line));
    } catch (const LineError& error) {
      throw render::InputError(fmt::format("{}:{}: {}", lines.name(), lines.number(), error.what()));
    }
  }
  if (!has_case) throw render::InputError(lines.name() + ": no cases");
}

}  // namespace occlude::cases
