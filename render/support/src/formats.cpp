// SPDX-License-Identifier: MIT
#include "occlude/render/formats.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>

namespace occlude::render {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '&')
      result += "&amp;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

std::string grouped(double value) {
  std::string digits = fmt::format("{:.0f}", value);
  for (auto i = static_cast<std::ptrdiff_t>(digits.size()) - 3; i > 0; i -= 3)
    digits.insert(static_cast<std::size_t>(i), ",");
  return digits;
}

std::string rounded(double value, int digits) {
  const double unit = std::pow(10, digits);
  return fmt::format("{:.{}f}", std::round(unit * value) / unit + 0.0, digits);
}

std::string short_of(double value) { return fmt::format("{:.6g}", value); }

std::string percent(double share) { return fmt::format("{:.1f} %", 100 * share); }

std::string fps(const std::optional<double>& ms, const char* none) { return ms ? fmt::format("{:.1f}", 1000 / *ms) : none; }

std::string gain(const std::optional<double>& ratio, const char* none) {
  return ratio ? fmt::format("{:+.0f} %", 100 * (*ratio - 1)) : none;
}

}  // namespace occlude::render
