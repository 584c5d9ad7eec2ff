// SPDX-License-Identifier: MIT
#include "occlude/render/page.h"

#include <fmt/format.h>

#include <cstddef>

#include "page_files.h"

namespace occlude::render {
std::string page(const std::string& title, const std::string& body) {
  return fmt::format(
      R"(<!doctype html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1"><title>{}</title><style>{}</style></head><body>
{}</body></html>
)",
      title, page_file("page.css"), body);
}

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

std::string percent(double share) { return fmt::format("{:.1f} %", 100 * share); }

std::string fps(const std::optional<double>& ms, const char* none) { return ms ? fmt::format("{:.1f}", 1000 / *ms) : none; }

std::string gain(const std::optional<double>& ratio, const char* none) {
  return ratio ? fmt::format("{:+.0f} %", 100 * (*ratio - 1)) : none;
}

}  // namespace occlude::render
