// SPDX-License-Identifier: MIT
// How far points are moved by the eyes of a region, in a picture that has a plane in focus.
//
// Let e be an eye, relative to the middle of the region and in the axes of the picture, and p a point at (x, y, 1) / k: k is
// its nearness. A ray from e is named by where it passes the plane at 1 / f along the line of sight, as a multiple of that
// distance. The ray from e through p passes it at
//
//   (x, y) + (f - k) (e.xy - e.z (x, y)) / (1 - e.z k).
//
// So points in focus do not move, and all other moves are f - k times what does not depend on f.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "occlude/culler/camera.h"

namespace occlude::culler {

class EyeMoves {
 public:
  /// From the least to the greatest.
  struct Range {
    double low, high;

    [[nodiscard]] Range times(double factor) const {
      return factor >= 0 ? Range{factor * low, factor * high} : Range{factor * high, factor * low};
    }
  };

  EyeMoves() = default;
  /// `axes` are those along which (x, y, 1) / k is measured.
  EyeMoves(const EyeRegion& eyes, const Camera::Axes& axes) : axes_(axes), square_(eyes.radius * eyes.radius) {
    corners_[0] = {0, 0, 0};
    for (const glm::dvec3& half_edge : eyes.half_edges) {
      if (half_edge == glm::dvec3(0)) continue;
      const glm::dvec3 h{glm::dot(half_edge, axes.right), glm::dot(half_edge, axes.up), glm::dot(half_edge, axes.forward)};
      for (std::size_t i = 0; i < count_; ++i) {
        corners_[count_ + i] = corners_[i] + h;
        corners_[i] -= h;
      }
      count_ *= 2;
    }
  }

  /// The moves along the direction (across, up) of the point at (x, y, 1) / nearness, for a focus of nearness + 1. Up to
  /// rounding by 2^-46 of the size of its terms. REQUIRES: no eye reaches as far as the point.
  ///
  /// A quotient (a . e) / (1 - e.z k) has its extremes over a box at corners. Over a ball of radius r, a value t is one if
  /// the plane (a + t k z) . e = t touches the ball: t^2 = r^2 |a + t k z|^2.
  [[nodiscard]] Range along(double across, double up, double x, double y, double nearness) const {
    const glm::dvec3 a{across, up, -(across * x + up * y)};
    if (square_ > 0) return of_ball(a, nearness);
    Range range{0, 0};
    for (std::size_t i = 0; i < count_; ++i) {
      const double move = glm::dot(a, corners_[i]) / (1 - corners_[i].z * nearness);
      range = {std::min(range.low, move), std::max(range.high, move)};
    }
    return range;
  }

 private:
  [[nodiscard]] Range of_ball(const glm::dvec3& a, double nearness) const {
    const glm::dvec3 of = a.x * axes_.right + a.y * axes_.up + a.z * axes_.forward;
    const double divisor = 1 - square_ * nearness * nearness * glm::dot(axes_.forward, axes_.forward);
    const double middle = square_ * nearness * glm::dot(of, axes_.forward);
    const double half = std::sqrt(middle * middle + divisor * square_ * glm::dot(of, of));
    return {(middle - half) / divisor, (middle + half) / divisor};
  }

  Camera::Axes axes_{};
  double square_ = 0;                    ///< of the radius of the ball
  std::array<glm::dvec3, 8> corners_{};  ///< of the box
  std::size_t count_ = 1;
};

}  // namespace occlude::culler
