// SPDX-License-Identifier: MIT
#include "occlude/render/page.h"

#include <fmt/format.h>

#include <cstddef>

namespace occlude::render {
namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light; --ink: #1d2430; --soft: #5b6676; --line: #dde2e8; --paper: #ffffff; --wash: #f5f7f9; }
body { font: 16px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper); max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.7rem; margin-bottom: .2rem; } h2 { font-size: 1.2rem; margin-top: 2.4rem; }
p.lead, figcaption, .soft { color: var(--soft); }
.facts { display: grid; grid-template-columns: repeat(auto-fit, minmax(11rem, 1fr)); gap: .8rem; margin: 1.5rem 0; }
.fact { background: var(--wash); border-radius: .6rem; padding: .8rem 1rem; } .fact b { display: block; font-size: 1.6rem; }
.fact.bad { background: #fdecea; color: #a3201a; }
.wide { overflow-x: auto; } table { border-collapse: collapse; width: 100%; } th, td { text-align: right; padding: .45rem .7rem; border-bottom: 1px solid var(--line); }
th:first-child, td:first-child { text-align: left; } thead th { font-weight: 600; color: var(--soft); }
svg { width: 100%; height: auto; font: 13px system-ui, sans-serif; fill: var(--ink); } svg polyline { fill: none; stroke-width: 1.3; }
svg .grid { stroke: var(--line); }
figure { margin: 1rem 0; } figure img { width: 100%; border-radius: .4rem; display: block; } figcaption { font-size: .9rem; margin-top: .4rem; }
)";

}  // namespace

std::string page(const std::string& title, const std::string& body) {
  return fmt::format(
      R"(<!doctype html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1"><title>{}</title><style>{}</style></head><body>
{}</body></html>
)",
      title, kStyle, body);
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

std::string fps(const std::optional<double>& ms, const char* none) { return ms ? fmt::format("{:.1f}", 1000 / *ms) : none; }

std::string gain(const std::optional<double>& ratio, const char* none) {
  return ratio ? fmt::format("{:+.0f} %", 100 * (*ratio - 1)) : none;
}

}  // namespace occlude::render
