// SPDX-License-Identifier: MIT
// What a frame draws of a triangle: a convex loop in the coarse picture.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "beam_picture.h"

namespace occlude::culler {

/// A vertex in the picture.
struct CoverVertex {
  Corner corner;
  float nearness;  ///< a lower bound
};

struct CoverOutline {
  /// The smallest upright rectangle around positions and their errors.
  struct Extent {
    Place low{kNone, kNone}, high{-kNone, -kNone};

    void hold(const Corner& corner) {
      low = {std::min(low.x, corner.place.x - corner.error), std::min(low.y, corner.place.y - corner.error)};
      high = {std::max(high.x, corner.place.x + corner.error), std::max(high.y, corner.place.y + corner.error)};
    }
    void hold(const Extent& other) {
      low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y)};
      high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y)};
    }
    [[nodiscard]] bool is_empty() const { return !(low.x <= high.x); }
    /// False only if it is beside the rectangle.
    [[nodiscard]] bool may_meet(const PixelRectangle& r) const {
      return !(high.x < r.x0 || low.x > r.x1 || high.y < r.y0 || low.y > r.y1);
    }

    static constexpr double kNone = std::numeric_limits<double>::infinity();
  };

  std::array<Corner, 4> corners{};  ///< the near plane may cut one off
  std::size_t count = 0;
  Extent extent;
  float nearness = std::numeric_limits<float>::infinity();  ///< no corner has less

  void hold(const CoverVertex& vertex) {
    corners[count++] = vertex.corner;
    extent.hold(vertex.corner);
    nearness = std::min(nearness, vertex.nearness);
  }

  /// In pixels, up to rounding.
  [[nodiscard]] double area() const {
    double doubled = 0;
    for (std::size_t i = 2; i < count; ++i) {
      const Place &a = corners[0].place, &b = corners[i - 1].place, &c = corners[i].place;
      doubled += (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    }
    return std::fabs(doubled) / 2;
  }
};

}  // namespace occlude::culler
