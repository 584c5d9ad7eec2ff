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

/// `x` ascends; all series have its length. Both axes are linear and y begins at 0.
[[nodiscard]] std::string line_chart(const std::string& x_label, const std::string& y_label, const std::vector<double>& x,
                                     const std::vector<Series>& series);

}  // namespace occlude::render
