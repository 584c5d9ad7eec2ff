// SPDX-License-Identifier: MIT
// An edge in the coarse picture, as wide as its ends are out.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "beam_picture.h"

namespace occlude::culler {

class SeenEdge {
 public:
  struct Range {
    double low = std::numeric_limits<double>::infinity(), high = -low;

    void hold(const Range& other) {
      low = std::min(low, other.low);
      high = std::max(high, other.high);
    }
  };

  SeenEdge() = default;
  SeenEdge(const Corner& p, const Corner& q)
      : low_(p.place.y <= q.place.y ? p.place : q.place),
        high_(p.place.y <= q.place.y ? q.place : p.place),
        error_(std::max(p.error, q.error)),
        rise_(high_.y - low_.y),
        slope_((high_.x - low_.x) / rise_),  // not used without a rise
        // A place on the edge rounds five times more.
        wide_(error_ + 0x1p-50 * (std::fabs(low_.x) + std::fabs(high_.x))),
        whole_{std::min(low_.x, high_.x) - wide_, std::max(low_.x, high_.x) + wide_} {}

  [[nodiscard]] double low() const { return low_.y; }
  [[nodiscard]] double high() const { return high_.y; }
  [[nodiscard]] double error() const { return error_; }

  /// From where to where it reaches across between two heights, or as near them as its ends are out. None where it does not
  /// come near them.
  [[nodiscard]] Range between(double low, double high) const {
    const double from = low - error_ - low_.y, to = high + error_ - low_.y;
    if (to < 0 || from > rise_) return {};
    if (from <= 0 && to >= rise_) return whole_;
    const double first = low_.x + std::max(from, 0.0) * slope_, last = low_.x + std::min(to, rise_) * slope_;
    return {std::min(first, last) - wide_, std::max(first, last) + wide_};
  }

 private:
  Place low_{}, high_{};
  double error_ = 0, rise_ = 0, slope_ = 0, wide_ = 0;
  Range whole_;
};

}  // namespace occlude::culler
