// SPDX-License-Identifier: MIT
// Whether rectangles cover another.
#pragma once

#include <array>
#include <vector>

namespace occlude::oracle {

struct Rectangle {
  std::array<double, 2> low, high;
};

/// Whether the rectangle, of which each side has the coordinate of a side of one of the others, lies in their union. All are
/// closed. The rectangle may be a segment or a point, the others have area.
[[nodiscard]] bool is_covered(const Rectangle& rectangle, std::vector<Rectangle> others);

}  // namespace occlude::oracle
