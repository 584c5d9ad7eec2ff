// SPDX-License-Identifier: MIT
// What a frame draws of a triangle: a convex loop in the coarse picture.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "cover/conservative_viewport.h"

namespace occlude::culler {

/// A vertex in the picture.
struct CoverVertex {
  MovedPosition corner;
  float nearness;  ///< a lower bound
};

/// What a frame draws of a triangle: a convex loop, because the near plane may cut a corner off. None of it if it is empty.
struct CoverLoop {
  std::array<CoverVertex, 4> vertices;
  std::size_t count = 0;

  void add(const CoverVertex& vertex) { vertices[count++] = vertex; }
};

/// Where a loop is in the picture.
struct CoverOutline {
  /// The smallest upright rectangle around positions, with their errors and as they are moved.
  struct Extent {
    PixelPosition low{kNone, kNone}, high{-kNone, -kNone};

    void hold(const MovedPosition& corner) {
      low = {std::min(low.x, corner.low.x - corner.error), std::min(low.y, corner.low.y - corner.error)};
      high = {std::max(high.x, corner.high.x + corner.error), std::max(high.y, corner.high.y + corner.error)};
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

  Extent extent;
  double area = 0;                                          ///< in pixels, up to rounding
  float nearness = std::numeric_limits<float>::infinity();  ///< no corner has less

  explicit CoverOutline(const CoverLoop& loop) {
    for (std::size_t i = 0; i < loop.count; ++i) {
      hold(loop.vertices[i]);
      if (i >= 2) area += area_of(loop.vertices[0], loop.vertices[i - 1], loop.vertices[i]);
    }
    area = std::fabs(area);
  }
  /// Of a triangle that is not cut.
  CoverOutline(const CoverVertex& a, const CoverVertex& b, const CoverVertex& c) : area(std::fabs(area_of(a, b, c))) {
    hold(a);
    hold(b);
    hold(c);
  }

 private:
  void hold(const CoverVertex& vertex) {
    extent.hold(vertex.corner);
    nearness = std::min(nearness, vertex.nearness);
  }
  static double area_of(const CoverVertex& first, const CoverVertex& second, const CoverVertex& third) {
    const PixelPosition &a = first.corner.place, &b = second.corner.place, &c = third.corner.place;
    return ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
  }
};

}  // namespace occlude::culler
