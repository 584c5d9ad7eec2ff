// SPDX-License-Identifier: MIT
#include "occlude/render/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "occlude/render/formats.h"

namespace occlude::render {
namespace {

// Coordinates of the drawing; the page scales it to its width.
constexpr double kWidth = 960, kLeft = 86, kRight = 44, kTop = 12, kBottom = 44, kLegendRow = 22;
constexpr double kLetter = 7.2;  ///< about the width of one

/// A round step (1, 2 or 5 times a power of ten) that divides `range` into about five.
double round_step(double range) {
  const double rough = range / 5, power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough) return factor * power;
  }
  return 10 * power;
}

/// Maps values to one side of the drawing, and lists the values labelled there.
struct Side {
  Scale scale = Scale::linear;
  double low = 0, high = 1;
  double from = 0, to = 1;  ///< coordinates of low and high
  std::vector<double> ticks;

  [[nodiscard]] double place(double value) const {
    const double share =
        scale == Scale::linear ? (value - low) / (high - low) : std::log(value / low) / std::log(high / low);
    return from + share * (to - from);
  }
};

std::vector<double> round_values(double low, double high, double step) {
  std::vector<double> values;
  // Multiples of the step, so that rounding does not accumulate: 0.3, not 0.30000000000000004.
  for (double i = std::ceil(low / step); i * step <= high + step * 1e-9; ++i) values.push_back(i * step);
  return values;
}

/// 1, 2 and 5 times the powers of ten; the powers alone if those are too many.
std::vector<double> round_values_by_ratio(double low, double high) {
  std::vector<double> values;
  const bool is_wide = high / low > 1000;
  for (double power = std::pow(10, std::floor(std::log10(low))); power <= high * 1.0001; power *= 10) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double value = factor * power;
      if (value >= low * 0.9999 && value <= high * 1.0001 && (factor == 1 || !is_wide)) values.push_back(value);
    }
  }
  return values;
}

Side x_side(Scale scale, const std::vector<double>& x) {
  Side side{scale, x.front(), x.back(), kLeft, kWidth - kRight, x};
  if (side.high <= side.low) side.high = scale == Scale::linear ? side.low + 1 : side.low * 2;
  if (scale == Scale::linear) side.ticks = round_values(side.low, side.high, round_step(side.high - side.low));
  return side;
}

Side y_side(Scale scale, const std::vector<Series>& series, double from, double to) {
  double low = series.front().y.front(), high = low;
  for (const Series& s : series) {
    low = std::min(low, std::ranges::min(s.y));
    high = std::max(high, std::ranges::max(s.y));
  }
  Side side{scale, 0, high > 0 ? high : 1, from, to, {}};
  if (scale == Scale::linear) {
    const double step = round_step(side.high);
    side.high = std::ceil(side.high / step) * step;
    side.ticks = round_values(0, side.high, step);
  } else {
    side.low = low / 1.2;  // a little room above and below the lines
    side.high = high * 1.2;
    side.ticks = round_values_by_ratio(side.low, side.high);
  }
  return side;
}

std::string number(double value) { return value >= 1000 ? grouped(value) : fmt::format("{:g}", value); }

std::string grid(const Side& x, const Side& y) {
  std::string svg;
  for (const double value : y.ticks) {
    fmt::format_to(
        std::back_inserter(svg),
        R"(<line class="grid" x1="{0}" x2="{1}" y1="{2:.1f}" y2="{2:.1f}"/><text x="{3}" y="{4:.1f}" text-anchor="end">{5}</text>)",
        kLeft, kWidth - kRight, y.place(value), kLeft - 8, y.place(value) + 4, number(value));
  }
  double end = -kWidth;  // of the last label
  for (const double value : x.ticks) {
    const std::string label = number(value);
    const double half = kLetter / 2 * static_cast<double>(label.size());
    if (x.place(value) - half < end + kLetter) continue;
    end = x.place(value) + half;
    fmt::format_to(std::back_inserter(svg), R"(<text x="{:.1f}" y="{:.1f}" text-anchor="middle">{}</text>)", x.place(value),
                   y.from + 18, label);
  }
  return svg;
}

std::string polyline(const Side& x_axis, const Side& y_axis, const std::vector<double>& x, const Series& series) {
  std::string points, dots;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double px = x_axis.place(x[i]), py = y_axis.place(series.y[i]);
    fmt::format_to(std::back_inserter(points), "{:.1f},{:.1f} ", px, py);
    if (x_axis.scale == Scale::linear) continue;
    fmt::format_to(std::back_inserter(dots), R"(<circle cx="{:.1f}" cy="{:.1f}" r="3" fill="{}"/>)", px, py, series.colour);
  }
  return fmt::format(R"(<polyline points="{}" stroke="{}"/>)", points, series.colour) + dots;
}

/// Adds the height of its rows to `top`.
std::string legend(const std::vector<Series>& series, double& top) {
  std::string svg;
  double x = kLeft;
  for (const Series& s : series) {
    const double width = 60 + kLetter * static_cast<double>(s.name.size());
    if (x > kLeft && x + width > kWidth) {
      x = kLeft;
      top += kLegendRow;
    }
    fmt::format_to(
        std::back_inserter(svg),
        R"(<line x1="{0}" x2="{1}" y1="{2}" y2="{2}" stroke="{3}" stroke-width="3"/><text x="{4}" y="{5}">{6}</text>)", x,
        x + 22, top + 2, s.colour, x + 28, top + 6, s.name);
    x += width;
  }
  top += kLegendRow;
  return svg;
}

}  // namespace

std::string line_chart(const Axis& x_axis, const Axis& y_axis, const std::vector<double>& x,
                       const std::vector<Series>& series, double height) {
  double top = kTop;
  const std::string names = legend(series, top);
  const Side along = x_side(x_axis.scale, x), up = y_side(y_axis.scale, series, top + height, top);
  const double bottom = top + height + kBottom;
  std::string svg = fmt::format(R"(<svg viewBox="0 0 {} {}" role="img" aria-label="{} over {}">)", kWidth, bottom,
                                y_axis.label, x_axis.label);
  svg += grid(along, up) + names;
  for (const Series& s : series) svg += polyline(along, up, x, s);
  svg += fmt::format(R"(<text x="{}" y="{}" text-anchor="middle">{}</text>)", (kLeft + kWidth - kRight) / 2, bottom - 6,
                     x_axis.label);
  svg += fmt::format(R"svg(<text transform="translate(14 {}) rotate(-90)" text-anchor="middle">{}</text></svg>)svg",
                     top + height / 2, y_axis.label);
  return svg;
}

std::string svg_file(const std::string& chart) {
  constexpr std::string_view kBegin = "<svg ";
  constexpr const char* kStyle =
      "<style>text{font:14px "
      "sans-serif;fill:#7d8590}.grid{stroke:#7d8590;stroke-opacity:.35}polyline{fill:none;stroke-width:3}"
      "</style>";
  const std::size_t content = chart.find('>') + 1;
  return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" {}{}{}\n",
                     chart.substr(kBegin.size(), content - kBegin.size()), kStyle, chart.substr(content));
}

}  // namespace occlude::render
