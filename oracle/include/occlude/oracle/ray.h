// SPDX-License-Identifier: MIT
// Single rays, decided exactly: what a ray meets, and which of two triangles it meets first.
#pragma once

#include <span>

#include "occlude/oracle/oracle.h"
#include "occlude/oracle/questions.h"
#include "occlude/oracle/visibility.h"

namespace occlude::oracle {

/// The ray from an eye through a point, or the whole line through it along a direction.
class Ray {
 public:
  /// REQUIRES: all numbers are finite; `through` is not the eye.
  Ray(const Viewpoint& view, const Point& through);

  /// Whether the ray meets the triangle within its borders, at a point inside all half-spaces and on the plane of none.
  [[nodiscard]] bool enters(const Triangle& triangle, std::span<const HalfSpaceCoefficients> within) const;

  enum class Order { apart, nearer, same, farther };

  /// Where the ray meets `other`, borders counted, in relation to where it meets `triangle`. They are apart if the ray does
  /// not meet `other` in the half-space. What lies in a plane with the ray counts as nearer. REQUIRES: enters(triangle, …).
  [[nodiscard]] Order order(const Triangle& triangle, const Triangle& other, const HalfSpaceCoefficients& drawn) const;

 private:
  Point from_, to_;  ///< of an eye; else the point and the direction
  bool is_eye_;
};

}  // namespace occlude::oracle
