// SPDX-License-Identifier: MIT
// The rays from a viewpoint as points of a projective plane. All questions about joined shadows are linear there.
//
// A point is given by its ray and by its nearness on that ray.
// - Seen from an eye V, the ray of x is y = x - V, and any positive multiple of y is the same ray. On the ray given by y,
//   the nearness of x is 1, and that of V + t y is 1/t.
// - Along a direction d, let k be an axis on which d is not zero. The ray is (y_i d_k - d_i y_k, y_j d_k - d_j y_k, 1) and
//   the nearness is -sign(d_k) y_k.
//
// The points of a plane then have a nearness that is linear in the ray, and a plane through the viewpoint is a line.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "big_integer.h"
#include "occlude/kernel/half_space.h"
#include "occlude/kernel/types.h"
#include "running_error.h"
#include "vector3.h"

namespace occlude::kernel {

template <class Number>
struct RayPoint {
  Vector3<Number> ray;
  Number nearness;
};

/// Doubles with a running error bound. Lengths are in units that make the largest about 1, directions are unchanged.
class RoundedUnits {
 public:
  using Number = RunningError;
  explicit RoundedUnits(double factor) : factor_(factor) {}
  [[nodiscard]] Number one() const { return {1, 0}; }
  [[nodiscard]] Number length(double x) const { return {x * factor_, 0}; }
  [[nodiscard]] Number direction(double x) const { return {x, 0}; }
  [[nodiscard]] Number offset(double x) const { return {x * factor_, 0}; }

 private:
  double factor_;  ///< a power of two
};

/// Integers. All lengths and directions are in units of 2^-shift.
class IntegerUnits {
 public:
  using Number = BigInteger;
  explicit IntegerUnits(int shift) : shift_(shift) {}
  [[nodiscard]] Number one() const { return 1; }
  [[nodiscard]] Number length(double x) const { return BigInteger::scaled(x, shift_); }
  [[nodiscard]] Number direction(double x) const { return BigInteger::scaled(x, shift_); }
  [[nodiscard]] Number offset(double x) const { return BigInteger::scaled(x, 2 * shift_); }

 private:
  int shift_;
};

template <class Units>
[[nodiscard]] auto lengths(const Units& units, const Vec3& v) {
  return Vector3<typename Units::Number>{units.length(v.x), units.length(v.y), units.length(v.z)};
}

template <class Units>
[[nodiscard]] auto directions(const Units& units, const Vec3& v) {
  return Vector3<typename Units::Number>{units.direction(v.x), units.direction(v.y), units.direction(v.z)};
}

/// A linear form on (ray, nearness) that is not negative on one side of a plane.
template <class Number>
struct RayForm {
  Vector3<Number> of_ray;
  Number of_nearness;
};

/// The power of two by which the largest component becomes at least 1 and less than 2. REQUIRES: v is not 0.
[[nodiscard]] inline double factor_to_about_1(const Vec3& v) {
  return std::ldexp(1, -std::ilogb(std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)})));
}

[[nodiscard]] inline Vec3 times(double factor, const Vec3& v) { return {factor * v.x, factor * v.y, factor * v.z}; }

class Rays {
 public:
  explicit Rays(const Viewpoint& view) : view_(view) {
    if (view.is_eye()) return;
    for (const int axis : {1, 2}) {
      if (std::fabs(view.value[axis]) > std::fabs(view.value[along_])) along_ = axis;
    }
    view_.value = times(factor_to_about_1(view.value), view.value);
  }

  /// The eye, or the direction scaled to a largest component of about 1.
  [[nodiscard]] const Viewpoint& viewpoint() const { return view_; }

  /// The point that is the sum of `terms`.
  template <class Units>
  [[nodiscard]] auto point(const Units& units, std::span<const Vec3> terms) const {
    using Number = typename Units::Number;
    Vector3<Number> x = lengths(units, terms[0]);
    for (const Vec3& term : terms.subspan(1)) x = x + lengths(units, term);
    if (view_.is_eye()) return RayPoint<Number>{x - lengths(units, view_.value), units.one()};
    const Vector3<Number> v = directions(units, view_.value);
    const auto across = [&](int axis) { return x[axis] * v[along_] - v[axis] * x[along_]; };
    return RayPoint<Number>{{across(first()), across(second()), units.one()}, is_backwards() ? x[along_] : -x[along_]};
  }

  template <class Units>
  [[nodiscard]] auto point(const Units& units, const Vec3& p) const {
    return point(units, std::span(&p, 1));
  }

  /// A form that is not negative in the half-space. REQUIRES: the largest component of its normal is about 1.
  template <class Units>
  [[nodiscard]] auto form(const Units& units, const HalfSpace& half_space) const {
    using Number = typename Units::Number;
    const Vector3<Number> n = directions(units, half_space.normal);
    const Number offset = units.offset(half_space.offset);
    if (view_.is_eye()) return RayForm<Number>{n, dot(n, lengths(units, view_.value)) + offset};
    const Vector3<Number> v = directions(units, view_.value);
    const auto forwards = [&](const Number& x) { return is_backwards() ? -x : x; };
    return RayForm<Number>{{forwards(n[first()]), forwards(n[second()]), forwards(v[along_]) * offset}, -dot(n, v)};
  }

 private:
  [[nodiscard]] bool is_backwards() const { return view_.value[along_] < 0; }
  [[nodiscard]] int first() const { return along_ == 0 ? 1 : 0; }
  [[nodiscard]] int second() const { return along_ == 2 ? 1 : 2; }

  Viewpoint view_;
  int along_ = 0;  ///< for a direction: the axis on which it is largest
};

}  // namespace occlude::kernel
