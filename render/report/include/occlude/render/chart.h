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

/// `x` ascends; there is a series, and all have its length. A linear x axis spans the values, and a linear y axis begins at
/// 0. A logarithmic axis needs positive values and spans them; its numbers along x are the values themselves, and each is
/// marked by a dot. `height` is that of the y axis, where the chart is 960 wide.
[[nodiscard]] std::string line_chart(const Axis& x_axis, const Axis& y_axis, const std::vector<double>& x,
                                     const std::vector<Series>& series, double height = 222);

}  // namespace occlude::render
