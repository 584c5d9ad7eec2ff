// SPDX-License-Identifier: MIT
// How measurements of many frames are told.
#pragma once

#include <string>
#include <vector>

#include "occlude/render/stopwatch.h"
#include "occlude/render/table.h"

namespace occlude::experiments {

/// Median, 99th percentile and maximum; milliseconds or numbers.
struct Spread {
  double median = 0, most_of_99 = 0, most = 0;
};

/// All 0 if there are no values.
[[nodiscard]] Spread spread_of(std::vector<double> values);

/// A table of spreads: what its heads are, and a row, the three numbers with so many digits after the point.
[[nodiscard]] std::vector<render::Column> spread_columns(const std::string& head);
[[nodiscard]] std::vector<render::Cell> row_of(const std::string& name, const Spread& spread, int digits);
[[nodiscard]] nlohmann::ordered_json json_of(const Spread& spread);

/// Milliseconds that work() takes.
template <class Work>
[[nodiscard]] double milliseconds(const Work& work) {
  const render::Stopwatch stopwatch;
  work();
  return stopwatch.milliseconds();
}

}  // namespace occlude::experiments
