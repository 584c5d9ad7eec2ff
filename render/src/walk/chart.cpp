// SPDX-License-Identifier: MIT
#include "chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace occlude::render {
namespace {

// The drawing's own coordinates, scaled by the page to its width.
constexpr double kWidth = 960, kHeight = 300, kLeft = 86, kRight = 12, kTop = 34, kBottom = 44;

/// A round step (1, 2 or 5 times a power of ten) that divides `range` into about five.
double round_step(double range) {
  const double rough = range / 5, power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough) return factor * power;
  }
  return 10 * power;
}

struct Axes {
  double x_min, x_max, y_max;
  [[nodiscard]] double x(double value) const {
    return kLeft + (value - x_min) / (x_max - x_min) * (kWidth - kLeft - kRight);
  }
  [[nodiscard]] double y(double value) const { return kHeight - kBottom - value / y_max * (kHeight - kTop - kBottom); }
};

std::string number(double value) {
  const auto whole = static_cast<long long>(value);
  return value >= 1000 ? fmt::format("{},{:03}", whole / 1000, whole % 1000) : fmt::format("{:g}", value);
}

std::string grid(const Axes& axes, double y_step) {
  std::string svg;
  for (double y = 0; y <= axes.y_max * 1.0001; y += y_step) {
    fmt::format_to(
        std::back_inserter(svg),
        R"(<line class="grid" x1="{0}" x2="{1}" y1="{2:.1f}" y2="{2:.1f}"/><text x="{3}" y="{4:.1f}" text-anchor="end">{5}</text>)",
        kLeft, kWidth - kRight, axes.y(y), kLeft - 8, axes.y(y) + 4, number(y));
  }
  const double x_step = round_step(axes.x_max - axes.x_min);
  for (double x = std::ceil(axes.x_min / x_step) * x_step; x <= axes.x_max; x += x_step) {
    fmt::format_to(std::back_inserter(svg), R"(<text x="{:.1f}" y="{}" text-anchor="middle">{:g}</text>)", axes.x(x),
                   kHeight - kBottom + 18, x);
  }
  return svg;
}

std::string polyline(const Axes& axes, const std::vector<double>& x, const Series& series) {
  std::string points;
  for (std::size_t i = 0; i < x.size(); ++i) {
    fmt::format_to(std::back_inserter(points), "{:.1f},{:.1f} ", axes.x(x[i]), axes.y(series.y[i]));
  }
  return fmt::format(R"(<polyline points="{}" stroke="{}"/>)", points, series.colour);
}

std::string legend(const std::vector<Series>& series) {
  std::string svg;
  double x = kLeft;
  for (const Series& s : series) {
    fmt::format_to(
        std::back_inserter(svg),
        R"(<line x1="{0}" x2="{1}" y1="14" y2="14" stroke="{2}" stroke-width="3"/><text x="{3}" y="18">{4}</text>)", x,
        x + 22, s.colour, x + 28, s.name);
    x += 60 + 7.2 * static_cast<double>(s.name.size());  // about the width of a letter
  }
  return svg;
}

}  // namespace

std::string line_chart(const std::string& x_label, const std::string& y_label, const std::vector<double>& x,
                       const std::vector<Series>& series) {
  double highest = 0;
  for (const Series& s : series) highest = std::max(highest, *std::max_element(s.y.begin(), s.y.end()));
  if (highest == 0) highest = 1;
  const double y_step = round_step(highest);
  const Axes axes{x.front(), std::max(x.back(), x.front() + 1), std::ceil(highest / y_step) * y_step};
  std::string svg =
      fmt::format(R"(<svg viewBox="0 0 {} {}" role="img" aria-label="{} over {}">)", kWidth, kHeight, y_label, x_label);
  svg += grid(axes, y_step) + legend(series);
  for (const Series& s : series) svg += polyline(axes, x, s);
  svg += fmt::format(R"(<text x="{}" y="{}" text-anchor="middle">{}</text>)", (kLeft + kWidth - kRight) / 2, kHeight - 6,
                     x_label);
  svg += fmt::format(R"svg(<text transform="translate(14 {}) rotate(-90)" text-anchor="middle">{}</text></svg>)svg",
                     (kTop + kHeight - kBottom) / 2, y_label);
  return svg;
}

}  // namespace occlude::render
