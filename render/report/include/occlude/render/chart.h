// SPDX-License-Identifier: MIT
// A line chart as inline SVG.
#pragma once

#include <string>
#include <vector>

namespace occlude::render {

struct Series {
  std::string name, colour;
  std::vector<double> y;  ///< one value for each x of the chart
};

enum class Scale { linear, logarithmic };

struct Axis {
  std::string label;
  Scale scale = Scale::linear;
};

/// REQUIRES: `x` ascends; there is at least one series, and each has one value per x. A linear x axis spans the values, and
/// a linear y axis starts at 0. A logarithmic axis needs positive values and spans them; along x its labels are the values
/// themselves, as far as there is room for them, each marked by a dot. `height` is the height of the y axis; the chart is
/// 960 wide.
[[nodiscard]] std::string line_chart(const Axis& x_axis, const Axis& y_axis, const std::vector<double>& x,
                                     const std::vector<Series>& series, double height = 222);

/// A chart as a file of its own, to be read on light and dark ground. Inside a page its style is that of the page.
[[nodiscard]] std::string svg_file(const std::string& chart);

}  // namespace occlude::render
