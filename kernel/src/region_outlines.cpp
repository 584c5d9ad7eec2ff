// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

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
    for (const PlaneRecipe& recipe : frustum_.recipes) planes_.push_back(coefficients<Twice>(frustum_, recipe));
  }

  void add_outlines(int axis) {
    for (std::size_t i = 1; i < planes_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (sign_along(i, axis) * sign_along(j, axis) < 0) add_outline(planes_[i], planes_[j], axis);
      }
    }
  }

  /// Three planes bound the shadow along `axis` if weights of one sign make a plane of them that is across it.
  void add_extents(int axis) {
    for (std::size_t i = 2; i < planes_.size(); ++i) {
      for (std::size_t j = 1; j < i; ++j) {
        for (std::size_t m = 0; m < j; ++m) add_extent(axis, i, j, m);
      }
    }
  }

 private:
  [[nodiscard]] int sign_along(std::size_t plane, int axis) const {
    return certified([&]<class A>(A& arithmetic) {
      return arithmetic.sign(coefficients<A>(frustum_, frustum_.recipes[plane]).normal[axis]);
    });
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

  template <class A>
  static typename A::Number minor(const PlaneCoefficients<A>& a, const PlaneCoefficients<A>& b, int axis) {
    const int k = (axis + 1) % 3, l = (axis + 2) % 3;
    return a.normal[k] * b.normal[l] - b.normal[k] * a.normal[l];
  }
  [[nodiscard]] int turn(std::size_t a, std::size_t b, int axis) const {
    return certified([&]<class A>(A& arithmetic) {
      const auto plane = [&](std::size_t i) { return coefficients<A>(frustum_, frustum_.recipes[i]); };
      return arithmetic.sign(minor<A>(plane(a), plane(b), axis));
    });
  }

  void add_extent(int axis, std::size_t i, std::size_t j, std::size_t m) {
    const int turn_of_m = turn(i, j, axis);
    if (turn_of_m == 0 || turn(j, m, axis) != turn_of_m || turn(m, i, axis) != turn_of_m) return;
    const Coefficients &a = planes_[i], &b = planes_[j], &c = planes_[m];
    const DoubleDouble of_a = minor<Twice>(b, c, axis), of_b = minor<Twice>(c, a, axis), of_c = minor<Twice>(a, b, axis);
    const DoubleDouble slope = of_a * a.normal[axis] + of_b * b.normal[axis] + of_c * c.normal[axis];
    const DoubleDouble offset = of_a * a.offset + of_b * b.offset + of_c * c.offset;
    // The sum is (slope (x - origin) + offset) times the sign of the weights: a bound of x from below or from above.
    const bool is_from_below = (slope.high > 0) == (turn_of_m > 0);
    const Enclosed bound = quotient(-offset, slope, frustum_.origin[axis]);
    Extent& extent = shadow_.extents[static_cast<std::size_t>(axis)];
    if (!is_certain(slope)) {  // it bounds x on one side or the other, nobody can tell where
      extent.least.high = std::numeric_limits<double>::infinity();
      extent.greatest.low = -std::numeric_limits<double>::infinity();
    } else if (is_from_below) {
      extent.least = {std::max(extent.least.low, bound.low), std::max(extent.least.high, bound.high)};
    } else {
      extent.greatest = {std::min(extent.greatest.low, bound.low), std::min(extent.greatest.high, bound.high)};
    }
  }

  static double doubt(const DoubleDouble& x) { return std::fabs(x.low.value) + x.low.error; }
  static bool is_certain(const DoubleDouble& x) { return std::fabs(x.high) > 4 * doubt(x); }

  /// Encloses origin + a / b. With q the rounded quotient of the high parts, a / b differs from it by at most
  /// (doubt(a) + q doubt(b)) / (|b| - doubt(b)), and by a rounding of q; the sum rounds once more. All of it is at most half
  /// of what is taken, because |b| > 4 doubt(b).
  static Enclosed quotient(const DoubleDouble& a, const DoubleDouble& b, double origin) {
    const double q = a.high / b.high, sum = origin + q;
    const double from_doubt = (doubt(a) + std::fabs(q) * doubt(b)) / (std::fabs(b.high) - doubt(b));
    const double error = 2 * from_doubt + 4 * kUnitRoundoff * (std::fabs(q) + std::fabs(sum));
    return {sum - error, sum + error};
  }

  StoredRegionShadow& shadow_;
  const StoredFrustum& frustum_;
  std::vector<Coefficients> planes_;
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
