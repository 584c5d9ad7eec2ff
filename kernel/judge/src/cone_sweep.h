// SPDX-License-Identifier: MIT
// The overlap of two convex cones with a common apex, by a sweep round a corner. Its time is linear in their edges (section
// 5.2).
//
// The pivot O is corner 0 of the occludee B, and the sweep turns a half-plane about the ray through O. B is a fan of
// triangles about O. Of the occluder A only the rim counts: when O is outside of A, the edges that face O; otherwise the
// edges that do not pass through O. In every half-plane the rim is one ray, and so is the far side of B's fan.
//
// O in A: O is a common ray, and B is inside A when every corner of B lies before the rim. The paper sweeps about a common
// point to learn whether any edges cross. Locating the corners between the rim's edges takes fewer questions and gives the
// same answer.
//
// O outside of A: B cannot be inside. This is the paper's clip in the manner of Cyrus and Beck, in which a segment can enter
// only by an edge that faces its start. The chords of B from O are clipped, each by the one facing edge in its half-plane.
// B's fan turns through less than half a turn. In the image that puts O at infinity, the far side of the fan is a convex
// function and A's rim a concave one. If the two reach each other, they do so at a corner of one of them: a corner of B on
// or beyond the rim, whose chord crosses it, or a corner of the rim in the fan.
//
// The only question is the sign of one determinant, that of the viewpoint and three corners, of degree three. Points behind
// the eye are no exception. A half-plane about the ray through O ends at the opposite ray. That ray is in no fan, because a
// cone with corners holds no line, and it is no corner of a rim that faces O.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "occlude/kernel/view_cone.h"

namespace occlude::kernel {

/// Corners of a cone in counter-clockwise order round a pivot, each less than half a turn beyond the one before. When they
/// go all the way round, the first corner is repeated at the end. Otherwise all are within half a turn.
class Fan {
 public:
  Fan(std::span<const Vec3> corners, std::vector<std::size_t> order) : corners_(corners), order_(std::move(order)) {}

  [[nodiscard]] std::size_t size() const { return order_.size(); }
  [[nodiscard]] const Vec3& operator[](std::size_t i) const { return corners_[order_[i]]; }
  /// The index in the cone of corner i of the fan.
  [[nodiscard]] std::size_t number(std::size_t i) const { return order_[i]; }
  [[nodiscard]] bool is_closed() const { return order_.front() == order_.back(); }

 private:
  std::span<const Vec3> corners_;
  std::vector<std::size_t> order_;
};

/// `orientation(p, q, r)` is the sign of the side plane through p and q (silhouette.h) at r.
template <class Orientation>
class ConeSweep {
 public:
  ConeSweep(const Orientation& orientation, std::span<const Vec3> occluder, std::span<const Vec3> occludee)
      : orientation_(orientation), occluder_(occluder), occludee_(occludee), pivot_(occludee[0]) {}

  /// The relation and, where the cones meet, a common ray.
  [[nodiscard]] ConeOverlap overlap() const {
    const std::vector<int> signs = signs_at_pivot();
    const bool is_outside = std::any_of(signs.begin(), signs.end(), [](int sign) { return sign < 0; });
    const Fan rim = rim_of(signs, is_outside ? -1 : 1), fan = fan_of_occludee();
    if (!is_outside) return {holds_all(rim, fan) ? Relation::inside : Relation::partial, OccludeeCorner{0}};
    const std::optional<CommonRay> common = meeting(rim, fan);
    return {common ? Relation::partial : Relation::outside, common};
  }

 private:
  /// Finds the span of a fan, from one corner to the next, whose angle holds a corner of the other fan. Each search goes on
  /// where the last one ended: for corners in counter-clockwise order it turns at most twice in all.
  class Locator {
   public:
    Locator(const ConeSweep& sweep, const Fan& fan) : sweep_(sweep), fan_(fan) {}

    [[nodiscard]] std::optional<std::size_t> span_of(const Vec3& x) {
      const std::size_t spans = fan_.size() - 1;
      // A corner that is in no span must not cost a whole turn.
      if (!fan_.is_closed() && !sweep_.is_between(fan_[0], x, fan_[spans])) return std::nullopt;
      for (std::size_t turned = 0; turned < spans; ++turned, span_ = (span_ + 1) % spans) {
        if (sweep_.is_between(fan_[span_], x, fan_[span_ + 1])) return span_;
      }
      return std::nullopt;
    }

   private:
    const ConeSweep& sweep_;
    const Fan& fan_;
    std::size_t span_ = 0;
  };

  [[nodiscard]] std::vector<int> signs_at_pivot() const {
    std::vector<int> signs;
    for (std::size_t i = 0; i < occluder_.size(); ++i) {
      signs.push_back(orientation_(occluder_[i], occluder_[(i + 1) % occluder_.size()], pivot_));
    }
    return signs;
  }

  /// The edges of the occluder that have `sign` at the pivot. They are consecutive. Where `sign` is negative they run
  /// clockwise round the pivot, so their order is reversed.
  [[nodiscard]] Fan rim_of(const std::vector<int>& signs, int sign) const {
    const std::size_t n = signs.size();
    std::size_t first = 0;
    while (first < n && !(signs[first] == sign && signs[(first + n - 1) % n] != sign)) ++first;
    first %= n;  // where all edges have the sign, any may come first
    std::vector<std::size_t> order{first};
    for (std::size_t i = 0; i < n && signs[(first + i) % n] == sign; ++i) order.push_back((first + i + 1) % n);
    if (sign < 0) std::reverse(order.begin(), order.end());
    return {occluder_, std::move(order)};
  }

  [[nodiscard]] Fan fan_of_occludee() const {
    std::vector<std::size_t> order;
    for (std::size_t i = 1; i < occludee_.size(); ++i) order.push_back(i);
    return {occludee_, std::move(order)};
  }

  /// Whether x lies in the angle from `first` to `last`, which is at most half a turn.
  [[nodiscard]] bool is_between(const Vec3& first, const Vec3& x, const Vec3& last) const {
    return orientation_(pivot_, first, x) >= 0 && orientation_(pivot_, x, last) >= 0;
  }

  /// Where x lies in a span of a fan, seen from the pivot: 1 before the edge, 0 on it, -1 beyond it.
  [[nodiscard]] int side(const Fan& fan, std::size_t span, const Vec3& x) const {
    return orientation_(fan[span], fan[span + 1], x);
  }

  /// Whether every corner of the fan lies before the rim of an occluder that holds the pivot.
  [[nodiscard]] bool holds_all(const Fan& rim, const Fan& fan) const {
    Locator locator(*this, rim);
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const auto span = locator.span_of(fan[i]);
      if (!span || side(rim, *span, fan[i]) < 0) return false;
    }
    return true;
  }

  /// A ray that both cones share when the pivot is outside of the occluder.
  [[nodiscard]] std::optional<CommonRay> meeting(const Fan& rim, const Fan& fan) const {
    Locator in_rim(*this, rim), in_fan(*this, fan);
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const auto span = in_rim.span_of(fan[i]);
      // The rim runs against the order of the occluder's corners, so the edge between two of them starts at the later one.
      if (span && side(rim, *span, fan[i]) <= 0) return Crossing{rim.number(*span + 1), fan.number(i)};
    }
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const auto span = in_fan.span_of(rim[i]);
      if (span && side(fan, *span, rim[i]) >= 0) return OccluderCorner{rim.number(i)};
    }
    return std::nullopt;
  }

  const Orientation& orientation_;
  std::span<const Vec3> occluder_, occludee_;
  const Vec3& pivot_;
};

}  // namespace occlude::kernel
