// SPDX-License-Identifier: MIT
// Between two neighbouring sides across the first axis, the rectangles that are there are there from side to side. So they
// cover what their sides on the second axis cover.
#include "rectangles.h"

#include <algorithm>
#include <optional>

namespace occlude::oracle {

bool is_covered(const Rectangle& r, std::vector<Rectangle> others) {
  std::ranges::sort(others, {}, [](const Rectangle& other) { return other.low[1]; });
  std::vector<double> sides{r.low[0], r.high[0]};
  for (const Rectangle& other : others) {
    for (const double x : {other.low[0], other.high[0]}) {
      if (r.low[0] < x && x < r.high[0]) sides.push_back(x);
    }
  }
  std::ranges::sort(sides);
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    std::optional<double> reached;  // from the lower side of the rectangle on
    for (const Rectangle& other : others) {
      if (other.low[0] > sides[i] || other.high[0] < sides[i + 1]) continue;
      const double from = reached.value_or(r.low[1]);
      if (other.low[1] <= from && from <= other.high[1]) reached = other.high[1];
    }
    if (!reached || *reached < r.high[1]) return false;
  }
  return true;
}

}  // namespace occlude::oracle
