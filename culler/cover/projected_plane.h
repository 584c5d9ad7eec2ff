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
///
/// In a picture of several eyes, let g = n / h, and d = g . (x, y, 1) - f along a ray of position (x, y) with focus f. For
/// an eye e and the nearness k at which its ray meets the triangle, (k - f) (1 - e . g) >= d (1 - e_z k). Let the eyes reach
/// no farther than r < 1 along g, and no farther than c (1 - r) along g - k (0, 0, 1), for the least and the greatest k of
/// the triangle's vertices and so for all between. Then k is at least f + d (1 - c) if d is positive, and f + d (1 + c) if
/// not: the lesser of the two.
class ProjectedPlane {
 public:
  /// At most two functions.
  struct Bounds {
    std::array<PlaneBound, 2> of{};
    std::size_t count = 0;

    [[nodiscard]] const PlaneBound* begin() const { return of.data(); }
    [[nodiscard]] const PlaneBound* end() const { return of.data() + count; }
  };

  /// Takes the corners as the picture sees them. `reach` bounds |x| + |y| of the rays (x, y, 1) of the picture. With
  /// parallel rays, it bounds how far from the eye they start, in the sum of the axes.
  ProjectedPlane(const ConservativeViewport& picture, double reach, const EyePoint& a, const EyePoint& b, const EyePoint& c)
      : is_perspective_(picture.is_perspective()), is_of_region_(picture.is_of_region()), reach_(reach) {
    const std::array<glm::dvec3, 3> vertices{vector(a), vector(b), vector(c)};
    n_ = glm::cross(vertices[1] - vertices[0], vertices[2] - vertices[0]);
    if ((is_perspective_ ? glm::dot(n_, vertices[0]) : n_.z) < 0) n_ = -n_;
    h_ = glm::dot(n_, vertices[0]);
    for (const glm::dvec3& vertex : vertices) h_ = std::max(h_, glm::dot(n_, vertex));
    // In units of 2^-53 of the size of n times the depth, the products and their sum round by 3, and the size, the moves and
    // their product, which is no more than that, and the last sum by 5. error() is 16 of these, and points that are not cut
    // take 6.
    h_ += (std::fabs(n_.x) + std::fabs(n_.y) + std::fabs(n_.z)) * (picture.error() + picture.rounding());
    is_known_ = (is_perspective_ ? h_ : n_.z) > 0;
    if (!is_known_ || !is_of_region_) return;
    bend_ = bend_of(picture, n_ / h_, vertices);
    is_known_ = bend_ < kMostBend;
  }

  /// False if the triangle has no area, a parallel ray runs along it, up to rounding, or the eyes reach too far along it.
  [[nodiscard]] bool is_known() const { return is_known_; }

  /// The least of these is a lower bound of the nearness at which rays meet the triangle, in the picture with this focus.
  /// REQUIRES: is_known().
  [[nodiscard]] Bounds bounds(double focus) const {
    Bounds bounds;
    const auto add = [&](double at_middle, double more, double scale) {
      const double size = std::fabs(at_middle) + std::fabs(more) + (std::fabs(n_.x) + std::fabs(n_.y)) * reach_;
      bounds.of[bounds.count++] = {at_middle + more - kRounded * size, n_.x, n_.y, scale};
    };
    if (!is_perspective_) {
      add(-h_, 0, 1 / n_.z);
    } else if (!is_of_region_) {
      add(n_.z, 0, 1 / h_);
    } else {
      for (const double share : {1 - bend_, 1 + bend_}) add(n_.z, h_ * focus * (1 - share) / share, share / h_);
    }
    return bounds;
  }

 private:
  /// The linear function rounds four times in lower(), the slopes of its rays twice, and the constant twice. That is 8 times
  /// 2^-53 of its terms; the constant is 16.
  static constexpr double kRounded = 0x1p-49;

  /// With a larger c, the plane tells hardly more than the vertices.
  static constexpr double kMostBend = 0.75;

  static glm::dvec3 vector(const EyePoint& seen) { return {seen.right, seen.up, seen.forward}; }

  /// c, rounded up; 1 or more if there is none. What is before near() is not drawn.
  static double bend_of(const ConservativeViewport& picture, const glm::dvec3& g,
                        const std::array<glm::dvec3, 3>& vertices) {
    const double along_g = picture.reach(g);
    if (!(along_g < kMostBend)) return 1;
    double most = 0;
    const double moved = picture.error() + picture.rounding();
    for (const glm::dvec3& vertex : vertices) {
      const double forward = std::max(vertex.z, picture.near());
      for (const double k : {1 / (forward - moved), 1 / (forward + moved)}) {
        const double rounded = 0x1p-50 * (std::fabs(g.z) + k) * picture.eyes_forward();
        most = std::max(most, picture.reach({g.x, g.y, g.z - k}) + rounded);
      }
    }
    return kBoundRounded * most / (1 - along_g);
  }

  bool is_perspective_ = true, is_of_region_ = false, is_known_ = false;
  double reach_ = 0;
  glm::dvec3 n_{};  ///< n of the class, and h
  double h_ = 0;
  double bend_ = 0;  ///< c
};

}  // namespace occlude::culler
