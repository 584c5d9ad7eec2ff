// SPDX-License-Identifier: MIT
// A lower bound of the nearness of a triangle along the rays of a coarse picture: that of its plane.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "cover/conservative_viewport.h"
#include "cover/cover_tile.h"

namespace occlude::culler {

/// Let n be any vector, and h no less than n . v for each vertex v of the triangle, wherever v exactly is and is moved to.
/// The points p of the triangle lie between the vertices, so n . p <= h.
///  - A ray (x, y, 1) from the eye meets the triangle at p = f (x, y, 1). So f n . (x, y, 1) <= h, and if h is positive, the
///    nearness 1 / f is at least n . (x, y, 1) / h.
///  - A parallel ray meets it at p = (x, y, f). So n_z f <= h - n . (x, y, 0), and if n_z is positive, the nearness -f is at
///    least (n . (x, y, 0) - h) / n_z.
/// The normal of the plane makes these the nearness of the plane. It need not be exact, nor the triangle have an area.
class ProjectedPlane {
 public:
  /// Takes the corners as the picture sees them. `reach` bounds |x| + |y| of the rays (x, y, 1) of the picture. With
  /// parallel rays, it bounds how far from the eye they start, in the sum of the axes.
  ProjectedPlane(const ConservativeViewport& picture, double reach, const EyePoint& a, const EyePoint& b,
                 const EyePoint& c) {
    const std::array<glm::dvec3, 3> vertices{vector(a), vector(b), vector(c)};
    glm::dvec3 n = glm::cross(vertices[1] - vertices[0], vertices[2] - vertices[0]);
    if ((picture.is_perspective() ? glm::dot(n, vertices[0]) : n.z) < 0) n = -n;
    double h = glm::dot(n, vertices[0]);
    for (const glm::dvec3& vertex : vertices) h = std::max(h, glm::dot(n, vertex));
    // In units of 2^-53 of the size of n times the depth, the products and their sum round by 3, and the size, the moves and
    // their product, which is no more than that, and the last sum by 5. error() is 16 of these, and points that are not cut
    // take 6.
    h += (std::fabs(n.x) + std::fabs(n.y) + std::fabs(n.z)) * (picture.error() + picture.rounding());
    const double divisor = picture.is_perspective() ? h : n.z, constant = picture.is_perspective() ? n.z : -h;
    is_known_ = divisor > 0;
    if (!is_known_) return;
    bound_ = {constant - kRounded * (std::fabs(constant) + (std::fabs(n.x) + std::fabs(n.y)) * reach), n.x, n.y,
              1 / divisor};
  }

  /// False if the triangle has no area, or a parallel ray runs along it, up to rounding.
  [[nodiscard]] bool is_known() const { return is_known_; }

  /// A lower bound of the nearness at which rays meet the triangle. REQUIRES: is_known().
  [[nodiscard]] const PlaneBound& bound() const { return bound_; }

 private:
  /// The linear function rounds four times in lower(), the slopes of its rays twice, and the constant twice. That is 8 times
  /// 2^-53 of its terms; the constant is 16.
  static constexpr double kRounded = 0x1p-49;

  static glm::dvec3 vector(const EyePoint& seen) { return {seen.right, seen.up, seen.forward}; }

  PlaneBound bound_{};
  bool is_known_ = false;
};

}  // namespace occlude::culler
