// SPDX-License-Identifier: MIT
// An edge in the coarse picture, widened by its error.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "cover/conservative_viewport.h"

namespace occlude::culler {

class ProjectedEdge {
 public:
  struct Range {
    double low = std::numeric_limits<double>::infinity(), high = -low;

    void hold(const Range& other) {
      low = std::min(low, other.low);
      high = std::max(high, other.high);
    }
  };

  ProjectedEdge() = default;
  ProjectedEdge(const BoundedPosition& p, const BoundedPosition& q) : ProjectedEdge(p, q, std::max(p.error, q.error)) {}
  /// An edge with this error, instead of the larger one of its ends.
  ProjectedEdge(const BoundedPosition& p, const BoundedPosition& q, double error)
      : low_(p.place.y <= q.place.y ? p.place : q.place),
        high_(p.place.y <= q.place.y ? q.place : p.place),
        error_(error),
        rise_(high_.y - low_.y),
        slope_((high_.x - low_.x) / rise_),  // not used without a rise
        // Computing a position on the edge rounds ten more times.
        wide_(error_ + 0x1p-49 * (std::fabs(low_.x) + std::fabs(high_.x))),
        whole_{std::min(low_.x, high_.x) - wide_, std::max(low_.x, high_.x) + wide_} {}

  [[nodiscard]] double error() const { return error_; }
  /// Bounds the horizontal error of a position on the edge.
  [[nodiscard]] double wide() const { return wide_; }

  /// The horizontal range of the edge between two heights, or as near to them as its error. Empty if it does not come
  /// that near.
  [[nodiscard]] Range between(double low, double high) const {
    const double from = low - error_ - low_.y, to = high + error_ - low_.y;
    if (to < 0 || from > rise_) return {};
    if (from <= 0 && to >= rise_) return whole_;
    const double first = low_.x + std::max(from, 0.0) * slope_, last = low_.x + std::min(to, rise_) * slope_;
    return {std::min(first, last) - wide_, std::max(first, last) + wide_};
  }

  /// A piece of the edge, from its low to its high end. No other piece comes as near to the window as the error of the edge.
  /// None if the whole edge does not come that near. The piece ends at most a few pixels from the window.
  [[nodiscard]] std::optional<PixelBounds> within(const PixelBounds& window) const {
    if (!(wide_ < kMostWide)) return PixelBounds{window.low, {window.low.x, window.high.y}};
    const double from = std::max(window.low.y - error_ - low_.y, 0.0), to = std::min(window.high.y + error_ - low_.y, rise_);
    if (from > to) return std::nullopt;
    PixelBounds part{low_, high_};
    if (from > 0) part.low = {low_.x + from * slope_, low_.y + from};
    if (to < rise_) part.high = {low_.x + to * slope_, low_.y + to};
    const double left = window.low.x - wide_ - kBeyond, right = window.high.x + wide_ + kBeyond;
    if (std::max(part.low.x, part.high.x) < left || std::min(part.low.x, part.high.x) > right) return std::nullopt;
    const double run = part.high.x - part.low.x, rise = part.high.y - part.low.y;
    const auto end_at = [&](PixelPosition& end, double x) {
      if (x != end.x) end = {x, end.y + (x - end.x) / run * rise};
    };
    end_at(part.low, std::clamp(part.low.x, left, right));
    end_at(part.high, std::clamp(part.high.x, left, right));
    return part;
  }

 private:
  /// A piece of an edge may reach this many pixels beyond the window. That is more than its rounding errors.
  static constexpr double kBeyond = 2;
  /// An edge with a larger error, in pixels, may be anywhere.
  static constexpr double kMostWide = 0x1p20;

  PixelPosition low_{}, high_{};
  double error_ = 0, rise_ = 0, slope_ = 0, wide_ = 0;
  Range whole_;
};

}  // namespace occlude::culler
