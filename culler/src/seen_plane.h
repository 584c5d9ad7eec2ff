// SPDX-License-Identifier: MIT
// How near the plane of a triangle is, at least, along the rays of a coarse picture.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "beam_picture.h"

namespace occlude::culler {

/// The plane n . x = h of a triangle, and by how much it may be out.
class SeenPlane {
 public:
  /// Corners as the picture sees them. `reach`: no ray of the picture has a larger |x| + |y| in (x, y, 1), nor, of parallel
  /// ones, starts farther from the eye in the sum of the axes.
  SeenPlane(const BeamPicture& picture, double reach, const Seen& a, const Seen& b, const Seen& c) {
    const double error = picture.error(), rounding = picture.rounding();
    const glm::dvec3 p{b.right - a.right, b.up - a.up, b.forward - a.forward};
    const glm::dvec3 q{c.right - a.right, c.up - a.up, c.forward - a.forward};
    double length = 0;
    for (int axis = 0; axis < 3; ++axis) length = std::max({length, std::fabs(p[axis]), std::fabs(q[axis])});
    glm::dvec3 n = glm::cross(p, q);
    double h = n.x * a.right + n.y * a.up + n.z * a.forward;
    // Edges are out by 2 e and a rounding, u = 2^-53; a component of the normal by four products of that with an edge, and
    // three roundings of two products of edges: 8 e l + 10 u l^2. Twice that makes room for the roundings of what follows.
    const double normal_error = 16 * error * (length + error) + 0x1p-48 * length * length;
    const double far = std::fabs(a.right) + std::fabs(a.up) + std::fabs(a.forward) + 3 * error;
    // A point x of the triangle that is moved by d lies at n . x = h + n . d.
    const double height_error = 2 * normal_error * far + 8 * length * length * error +
                                rounding * (std::fabs(n.x) + std::fabs(n.y) + std::fabs(n.z) + 3 * normal_error);
    // What the nearness is divided by is to be above 0: turned over, if need be.
    const double divisor = picture.is_perspective() ? h : n.z;
    const double divisor_error = picture.is_perspective() ? height_error : normal_error;
    is_known_ = std::fabs(divisor) > 4 * divisor_error;
    if (!is_known_) return;
    if (divisor < 0) {
      n = -n;
      h = -h;
    }
    x_ = n.x;
    y_ = n.y;
    if (picture.is_perspective()) {
      // The nearness 1 / f along (x, y, 1) is n . (x, y, 1) / h.
      constant_ = n.z - normal_error * (reach + 1);
    } else {
      // How far along is f = (h - n . (x, y, 0)) / n_z, the nearness -f.
      constant_ =
          -h - height_error - normal_error * reach - kRounded * (std::fabs(h) + (std::fabs(n.x) + std::fabs(n.y)) * reach);
    }
    more_ = (1 - kRounded) / (std::fabs(divisor) + divisor_error);
    less_ = (1 + kRounded) / (std::fabs(divisor) - divisor_error);
  }

  /// Nothing is known of the plane of a sliver, nor of one seen nearly edge-on.
  [[nodiscard]] bool is_known() const { return is_known_; }

  /// A part of the nearness that is the same for all rays between two heights.
  [[nodiscard]] double of_rows(double low_y, double high_y) const { return constant_ + y_ * (y_ > 0 ? low_y : high_y); }
  /// No ray of the rectangle meets the plane less near. REQUIRES: is_known().
  [[nodiscard]] double least_nearness(double of_rows, double low_x, double high_x) const {
    const double value = of_rows + x_ * (x_ > 0 ? low_x : high_x);
    return value * (value > 0 ? more_ : less_);
  }

 private:
  static constexpr double kRounded = 0x1p-50;

  double x_ = 0, y_ = 0, constant_ = 0, more_ = 0, less_ = 0;
  bool is_known_ = false;
};

}  // namespace occlude::culler
