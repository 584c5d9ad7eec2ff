// SPDX-License-Identifier: MIT
// A plane's coefficients rounded to doubles, and to twice their precision, with bounds on the rounding errors of its values.
#pragma once

#include <cmath>

#include "plane_coefficients.h"
#include "planes.h"

namespace occlude::kernel {

struct RoundedPlane {
  FilterPlane filter;
  FilterBound bound;
  RefinedPlane refined;
};

[[nodiscard]] RoundedPlane rounded(const PlaneCoefficients<DoubleDoubleArithmetic>& plane);

/// The bound of the plane whose coefficients are the high parts. Here and below, `Real` is double or a number type that
/// tracks rounding errors.
template <class Real>
[[nodiscard]] BasicFilterBound<Real> filter_bound(const Vector3<RoundedNumber<Real>>& n, const RoundedNumber<Real>& w) {
  using std::fabs;
  const auto uncertainty = [](const RoundedNumber<Real>& x) -> Real { return fabs(x.low) + x.error; };
  const Real magnitudes = fabs(n.x.high) + fabs(n.y.high) + fabs(n.z.high);
  const Real uncertainties = uncertainty(n.x) + uncertainty(n.y) + uncertainty(n.z);
  return {inflated<BoundOf::slope>(kPlaneError * magnitudes + uncertainties),
          inflated<BoundOf::base>(kOffsetError * fabs(w.high) + uncertainty(w))};
}

/// What high and low parts together leave uncertain. refined_value() makes up for the roundings of these sums.
template <class Real>
[[nodiscard]] BasicFilterBound<Real> refined_uncertainty(const Vector3<RoundedNumber<Real>>& n,
                                                         const RoundedNumber<Real>& w) {
  return {n.x.error + n.y.error + n.z.error, w.error};
}

/// The value of a refined plane at a vertex, and the most that it can be off by.
template <class Real>
struct RefinedValue {
  Real value, error;
  bool is_exact;  ///< nothing was rounded
};

/// Value of the plane n + m, w + v at a vertex of a box that reaches as far as `reach` from `origin`.
template <class Real>
[[nodiscard]] RefinedValue<Real> refined_value(const Vector3<Real>& n, const Real& w, const Vector3<Real>& m, const Real& v,
                                               const BasicFilterBound<Real>& uncertainty, const Real& reach,
                                               const Vector3<Real>& vertex, const Vector3<Real>& origin) {
  using std::fabs;
  const auto x = two_difference(vertex.x, origin.x), y = two_difference(vertex.y, origin.y),
             z = two_difference(vertex.z, origin.z);
  const auto px = two_product(n.x, x.high), py = two_product(n.y, y.high), pz = two_product(n.z, z.high);
  const auto xy = two_sum(px.high, py.high), xyz = two_sum(xy.high, pz.high), sum = two_sum(xyz.high, w);
  const Real lost = ((px.low + py.low) + (pz.low + xy.low)) + (xyz.low + sum.low);
  const Real tails = ((n.x * x.low + m.x * x.high) + (n.y * y.low + m.y * y.high)) + ((n.z * z.low + m.z * z.high) + v);
  const Real magnitude = (fabs(px.high) + fabs(py.high)) + (fabs(pz.high) + fabs(w));
  const Real open = uncertainty.slope * reach + uncertainty.base;
  const bool nothing_lost = px.low == 0 && py.low == 0 && pz.low == 0 && xy.low == 0 && xyz.low == 0 && sum.low == 0;
  const bool no_tails = x.low == 0 && y.low == 0 && z.low == 0 && m.x == 0 && m.y == 0 && m.z == 0 && v == 0;
  return {sum.high + (lost + tails), kRefinedError * magnitude + inflated<BoundOf::refined_value>(open),
          nothing_lost && no_tails && open == 0};
}

/// The sign of a plane. It is 0 with `is_certain` false when twice the precision of a double cannot tell it.
struct CertainSign {
  int sign = 0;
  bool is_certain = false;
};
[[nodiscard]] inline CertainSign refined_sign(const FilterPlane& plane, const RefinedPlane& tail, const Vec3& vertex,
                                              const Vec3& origin, double reach) {
  const auto real = [](const Vec3& v) { return constants<PlainArithmetic>(v); };
  const auto [value, error, is_exact] = refined_value(real(plane.normal), plane.offset, real(tail.normal), tail.offset,
                                                      tail.uncertainty, reach, real(vertex), real(origin));
  if (std::fabs(value) > error || is_exact) return {PlainArithmetic::sign(value), true};
  return {};
}

}  // namespace occlude::kernel
