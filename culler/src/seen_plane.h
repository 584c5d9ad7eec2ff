// SPDX-License-Identifier: MIT
// A lower bound of the nearness of a triangle's plane along the rays of a coarse picture.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "beam_picture.h"
#include "cover_tile.h"

namespace occlude::culler {

/// The plane n . x = h of a triangle, and bounds of its errors.
class SeenPlane {
 public:
  /// Takes the corners as the picture sees them. `reach` bounds |x| + |y| of the rays (x, y, 1) of the picture. With
  /// parallel rays, it bounds how far from the eye they start, in the sum of the axes.
  SeenPlane(const BeamPicture& picture, double reach, const Seen& a, const Seen& b, const Seen& c) {
    const double error = picture.error(), rounding = picture.rounding();
    const glm::dvec3 p{b.right - a.right, b.up - a.up, b.forward - a.forward};
    const glm::dvec3 q{c.right - a.right, c.up - a.up, c.forward - a.forward};
    double length = 0;
    for (int axis = 0; axis < 3; ++axis) length = std::max({length, std::fabs(p[axis]), std::fabs(q[axis])});
    glm::dvec3 n = glm::cross(p, q);
    double h = n.x * a.right + n.y * a.up + n.z * a.forward;
    // Edges have an error of 2 e and a rounding, u = 2^-53. A component of the normal has four products of that error with
    // an edge, and three roundings of two products of edges: 8 e l + 10 u l^2. Twice that leaves room for the roundings of
    // what follows.
    const double normal_error = 16 * error * (length + error) + 0x1p-48 * length * length;
    const double far = std::fabs(a.right) + std::fabs(a.up) + std::fabs(a.forward) + 3 * error;
    // If a point x of the triangle is moved by d, then n . x = h + n . d.
    const double height_error = 2 * normal_error * far + 8 * length * length * error +
                                rounding * (std::fabs(n.x) + std::fabs(n.y) + std::fabs(n.z) + 3 * normal_error);
    // The nearness is divided by this number, which must be positive. If it is negative, the plane is turned over.
    const double divisor = picture.is_perspective() ? h : n.z;
    const double divisor_error = picture.is_perspective() ? height_error : normal_error;
    is_known_ = std::fabs(divisor) > 4 * divisor_error;
    if (!is_known_) return;
    if (divisor < 0) {
      n = -n;
      h = -h;
    }
    bound_.of_x = n.x;
    bound_.of_y = n.y;
    if (picture.is_perspective()) {
      // Along (x, y, 1) the nearness 1 / f is n . (x, y, 1) / h.
      bound_.constant = n.z - normal_error * (reach + 1);
    } else {
      // The distance along a ray is f = (h - n . (x, y, 0)) / n_z, and the nearness is -f.
      bound_.constant =
          -h - height_error - normal_error * reach - kRounded * (std::fabs(h) + (std::fabs(n.x) + std::fabs(n.y)) * reach);
    }
    bound_.more = (1 - kRounded) / (std::fabs(divisor) + divisor_error);
    bound_.less = (1 + kRounded) / (std::fabs(divisor) - divisor_error);
  }

  /// False for the plane of a sliver and for one that is seen nearly edge-on: their errors are too large.
  [[nodiscard]] bool is_known() const { return is_known_; }

  /// A lower bound of the nearness at which rays meet the plane. REQUIRES: is_known().
  [[nodiscard]] const PlaneBound& bound() const { return bound_; }

 private:
  static constexpr double kRounded = 0x1p-50;

  PlaneBound bound_{};
  bool is_known_ = false;
};

}  // namespace occlude::culler
