// SPDX-License-Identifier: MIT
// Where points are in a coarse picture, in exact numbers. The doubles that a ConservativeViewport keeps define it.
#pragma once

#include <glm/vec3.hpp>

#include "cover/conservative_viewport.h"
#include "search.h"
#include "true_plane.h"

namespace occlude::bound_check {

/// The same direction; no longer than 1, and shorter by a share of less than 2^-100.
[[nodiscard]] Vector unit(const Vector& v);

class TruePicture {
 public:
  explicit TruePicture(const culler::ConservativeViewport& picture);

  /// Relative to the eye: to the right, up and along the line of sight. With parallel rays, `right` and `up` do not change
  /// along them.
  [[nodiscard]] Vector see(const Vector& point) const;
  /// To the right and up in pixels, and the nearness, of what see() returned.
  [[nodiscard]] Exact x(const Vector& seen) const { return middle_x_ + scale_x_ * slope(seen.x(), seen); }
  [[nodiscard]] Exact y(const Vector& seen) const { return middle_y_ + scale_y_ * slope(seen.y(), seen); }
  [[nodiscard]] Exact nearness(const Vector& seen) const { return is_perspective_ ? Exact(1 / seen.z()) : Exact(-seen.z()); }
  /// The ray through a position in pixels: (x, y, 1), or where a parallel ray is.
  [[nodiscard]] Exact ray_x(const Exact& x) const { return (x - middle_x_) / scale_x_; }
  [[nodiscard]] Exact ray_y(const Exact& y) const { return (y - middle_y_) / scale_y_; }
  /// The nearness at which a ray meets the plane through three points as see() returns them.
  [[nodiscard]] Exact nearness(const Vector& a, const Vector& b, const Vector& c, const Exact& x, const Exact& y) const;

  [[nodiscard]] const Vector& right() const { return right_; }
  [[nodiscard]] const Vector& up() const { return up_; }
  [[nodiscard]] const Vector& forward() const { return forward_; }

 private:
  [[nodiscard]] Exact slope(const Exact& aside, const Vector& seen) const {
    return is_perspective_ ? Exact(aside / seen.z()) : aside;
  }

  bool is_perspective_;
  Vector eye_, right_, up_, forward_;
  Exact middle_x_, middle_y_, scale_x_, scale_y_;
};

/// A picture of any camera. Points are moved by up to as much as a renderer in single precision may, or not at all.
[[nodiscard]] culler::ConservativeViewport any_picture(Choices& choices, bool is_moved);

/// A point for which the bounds of the picture hold. Some are just beyond its near plane, or far aside.
[[nodiscard]] std::optional<glm::dvec3> any_point(Choices& choices, const culler::ConservativeViewport& picture);

}  // namespace occlude::bound_check
