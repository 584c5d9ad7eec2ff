// SPDX-License-Identifier: MIT
#include "occlude/render/line_reader.h"

#include <fmt/format.h>

#include <string_view>

#include "occlude/render/errors.h"
#include "occlude/render/input_limits.h"
#include "occlude/render/progress.h"

namespace occlude::render {

bool LineReader::next(std::string& line) {
  check_interrupt();
  line.clear();
  std::string_view ahead = blocks_.ahead();
  if (ahead.empty()) return false;
  ++number_;
  for (; !ahead.empty(); ahead = blocks_.ahead()) {
    const std::string_view part = ahead.substr(0, ahead.find('\n'));
    line += part;
    if (line.size() > kMostJson) {
      throw InputError(fmt::format("{}:{}: the line is longer than {}", name(), number_, in_mebibytes(kMostJson)));
    }
    const bool has_end = part.size() < ahead.size();
    blocks_.use(part.size() + (has_end ? 1 : 0));
    if (has_end) break;
  }
  return true;
}

}  // namespace occlude::render
