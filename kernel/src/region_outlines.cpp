// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "plane_coefficients.h"
#include "rounded_plane.h"
#include "stored_region_shadow.h"

namespace occlude::kernel {
namespace {

using Twice = DoubleDoubleArithmetic;
using Coefficients = PlaneCoefficients<Twice>;

/// Makes what separates the shadow from axis-aligned boxes: all sums of two and of three planes that separation.h tries.
class Outliner {
 public:
  explicit Outliner(StoredRegionShadow& shadow) : shadow_(shadow), frustum_(shadow.planes) {
    for (std::size_t i = 0; i < frustum_.plane_count; ++i) {
      planes_.push_back(plane<Twice>(i));
      rounded_.push_back(plane<FilterArithmetic>(i));
    }
  }

  void add_outlines(int axis) {
    for (std::size_t i = 1; i < planes_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (sign_along(i, axis) * sign_along(j, axis) < 0) add_outline(planes_[i], planes_[j], axis);
      }
    }
  }

  /// Three planes bound the shadow along `axis` if weights of one sign make a plane of them that is across it. If they make
  /// none at all, as three planes along one line do that is not across the axis, their sum is the same everywhere.
  void add_extents(int axis) {
    for (std::size_t i = 2; i < planes_.size(); ++i) {
      for (std::size_t j = 1; j < i; ++j) {
        for (std::size_t m = 0; m < j; ++m) add_extent(axis, i, j, m);
      }
    }
  }

 private:
  template <class A>
  [[nodiscard]] PlaneCoefficients<A> plane(std::size_t i) const {
    return coefficients<A>(frustum_, frustum_.recipes[i]);
  }

  [[nodiscard]] int sign_along(std::size_t i, int axis) const {
    return certified([&]<class A>(A& arithmetic) { return arithmetic.sign(plane<A>(i).normal[axis]); });
  }

  void add_outline(const Coefficients& a, const Coefficients& b, int axis) {
    const DoubleDouble of_a = Twice::magnitude(b.normal[axis]), of_b = Twice::magnitude(a.normal[axis]);
    Vector3<DoubleDouble> normal = of_a * a.normal + of_b * b.normal;
    (axis == 0 ? normal.x : axis == 1 ? normal.y : normal.z) = Twice::constant(0);
    const auto [filter, bound, refined] = rounded({normal, of_a * a.offset + of_b * b.offset});
    shadow_.outlines.push_back(filter);
    FilterBound& common = shadow_.outline_bound;
    common = {std::max(common.slope, bound.slope), std::max(common.base, bound.base)};
  }

  /// The weight of the third of three planes whose sum changes along `axis` alone: of the others, by rotation.
  template <class A>
  static typename A::Number weight(const PlaneCoefficients<A>& a, const PlaneCoefficients<A>& b, int axis) {
    const int k = (axis + 1) % 3, l = (axis + 2) % 3;
    return a.normal[k] * b.normal[l] - b.normal[k] * a.normal[l];
  }

  /// Sign with which the sum of three planes, of weights >= 0, changes along the axis; 0 where there are no such weights.
  template <class A>
  static int sign_of_sum(A& arithmetic, const std::array<PlaneCoefficients<A>, 3>& p, int axis) {
    const std::array weights{weight(p[1], p[2], axis), weight(p[2], p[0], axis), weight(p[0], p[1], axis)};
    const int turn = arithmetic.sign(weights[0]);
    if (turn == 0 || arithmetic.sign(weights[1]) != turn || arithmetic.sign(weights[2]) != turn) return 0;
    return turn *
           arithmetic.sign(weights[0] * p[0].normal[axis] + weights[1] * p[1].normal[axis] + weights[2] * p[2].normal[axis]);
  }

  void add_extent(int axis, std::size_t i, std::size_t j, std::size_t m) {
    FilterArithmetic filter;
    int sign = sign_of_sum(filter, std::array{rounded_[i], rounded_[j], rounded_[m]}, axis);
    if (filter.failed()) {
      sign = exactly([&]<class A>(A& arithmetic) {
        return sign_of_sum(arithmetic, std::array{plane<A>(i), plane<A>(j), plane<A>(m)}, axis);
      });
    }
    if (sign == 0) return;
    const Coefficients &a = planes_[i], &b = planes_[j], &c = planes_[m];
    const DoubleDouble of_a = weight(b, c, axis), of_b = weight(c, a, axis), of_c = weight(a, b, axis);
    const DoubleDouble slope = of_a * a.normal[axis] + of_b * b.normal[axis] + of_c * c.normal[axis];
    const DoubleDouble offset = of_a * a.offset + of_b * b.offset + of_c * c.offset;
    const Enclosed bound = quotient(-offset, slope, frustum_.origin[axis]);
    Extent& extent = shadow_.extents[static_cast<std::size_t>(axis)];
    if (sign > 0) {
      extent.least = {std::max(extent.least.low, bound.low), std::max(extent.least.high, bound.high)};
    } else {
      extent.greatest = {std::min(extent.greatest.low, bound.low), std::min(extent.greatest.high, bound.high)};
    }
  }

  static double doubt(const DoubleDouble& x) { return std::fabs(x.low.value) + x.low.error; }
  /// Encloses origin + a / b. With q the rounded quotient of the high parts, a / b differs from it by at most
  /// (doubt(a) + |q| doubt(b)) / (|b| - doubt(b)) and by a rounding of q; the sum rounds once more. With |b| > 4 doubt(b)
  /// all of it is at most half of what is taken. Else nobody can tell.
  static Enclosed quotient(const DoubleDouble& a, const DoubleDouble& b, double origin) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (!(std::fabs(b.high) > 4 * doubt(b))) return {-kInfinity, kInfinity};
    const double q = a.high / b.high, sum = origin + q;
    const double from_doubt = (doubt(a) + std::fabs(q) * doubt(b)) / (std::fabs(b.high) - doubt(b));
    const double error = 2 * from_doubt + 4 * kUnitRoundoff * (std::fabs(q) + std::fabs(sum));
    return {sum - error, sum + error};
  }

  StoredRegionShadow& shadow_;
  const StoredFrustum& frustum_;
  std::vector<Coefficients> planes_;
  std::vector<PlaneCoefficients<FilterArithmetic>> rounded_;
};

}  // namespace

void add_outlines(StoredRegionShadow& shadow) {
  Outliner outliner(shadow);
  for (int axis = 0; axis < 3; ++axis) {
    outliner.add_outlines(axis);
    outliner.add_extents(axis);
  }
}

}  // namespace occlude::kernel
