// SPDX-License-Identifier: MIT
// Every error here is a sum of magnitudes of expressions that are linear in the coefficients of the plane and linear in the
// coordinates. Its bound is the product of a norm of the coefficients and a norm of the coordinates. So the error is a
// convex function on the set of all planes and boxes of norms at most one, and is largest at a corner of that set. A few
// planes and boxes are therefore enough.
#include "recompute.h"

#include <algorithm>
#include <functional>

#include "box_frame.h"
#include "certain_sign.h"
#include "error_bounds.h"
#include "product_difference.h"
#include "rounded_plane.h"
#include "running_error.h"
#include "traced_lane.h"
#include "traced_number.h"

namespace occlude::bound_check {
namespace {

using A = TracingArithmetic;
using kernel::Vec3;
using Vector = kernel::Vector3<TracedNumber>;
using Numbers = std::vector<TracedNumber>;

Exact largest_error(const TracedNumber& computed, double truth) {
  return TracedNumber::sum(computed, TracedNumber(-truth)).most();
}

/// The factor by which a bound must be multiplied to hold; the largest double when the bound may be zero.
Exact needed(const TracedNumber& computed, double truth, const TracedNumber& bound) {
  if (bound.least() <= 0) return Exact(std::numeric_limits<double>::max());
  return largest_error(computed, truth) / bound.least();
}

Vec3 along(int axis, double x) {
  Vec3 v;
  v[axis] = x;
  return v;
}

using Part = kernel::RoundedNumber<TracedNumber>;
using Normal = kernel::Vector3<Part>;
using Bound = kernel::BasicFilterBound<TracedNumber>;

Part exactly(double x) { return {x, 0, 0}; }

/// A plane with exact coefficients, and its bound as the kernel computes it.
struct BoundedPlane {
  BoundedPlane(const Vec3& n, double offset)
      : filter{n, {std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)}, offset, {}},
        bound(kernel::filter_bound(Normal{exactly(n.x), exactly(n.y), exactly(n.z)}, exactly(offset))) {}

  kernel::FilterPlane filter;
  Bound bound;
};

/// The normals at the corners of the set of planes.
void for_each_normal(const std::function<void(const Vec3&)>& use) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) use(along(axis, sign));
  }
}

/// The bounds of boxes, the same on each axis, at the corners of the set of boxes that reach as far as one.
constexpr std::array<std::array<double, 2>, 3> kIntervals{{{1, 1}, {-1, 1}, {-1, -1}}};

Vec3 uniform(double x) { return {x, x, x}; }

double sum(const Vec3& v) { return v.x + v.y + v.z; }

/// The factor needed for the values of a plane at both extremal vertices of a box, whose true values are known.
template <class Frame>
Exact needed_for(const Frame& frame, const BoundedPlane& p, double true_low, double true_high) {
  const auto extremes = frame.extremes(p.filter);
  const TracedNumber error = frame.error(p.bound);
  return std::max(needed(extremes.low(), true_low, error), needed(extremes.high(), true_high, error));
}

/// `Tracing` is the arithmetic of single boxes or of lanes.
template <class Tracing>
Exact needed_by_aabb(const BoundedPlane& p) {
  Exact most = 0;
  const auto& [n, magnitudes, offset, farther] = p.filter;
  for (const auto& [low, high] : kIntervals) {
    const kernel::AabbFrame<Tracing> frame({uniform(low), uniform(high)}, {});
    const double at_low = sum(n) * low, at_high = sum(n) * high;
    most = std::max(
        most, needed_for(frame, p, 2 * (std::min(at_low, at_high) + offset), 2 * (std::max(at_low, at_high) + offset)));
  }
  return most;
}

/// A box whose whole reach is that of half edge k, or of the centre for k = 3.
kernel::Obb obb(std::size_t k) {
  kernel::Obb box;
  (k < 3 ? box.half_edges[k] : box.center) = uniform(1);
  return box;
}

Exact needed_by_obb(const BoundedPlane& p) {
  Exact most = 0;
  const double along = sum(p.filter.normal);
  for (std::size_t k = 0; k < 4; ++k) {
    const double center = p.filter.offset + (k < 3 ? 0 : along), spread = k < 3 ? std::fabs(along) : 0;
    most = std::max(most, needed_for(kernel::ObbFrame<A>(obb(k), {}), p, center - spread, center + spread));
  }
  return most;
}

/// Calls `use` with the sum of numbers in every order of summation.
void for_each_order(const Numbers& terms, const std::function<void(const TracedNumber&)>& use) {
  if (terms.size() == 1) return use(terms[0]);
  for (std::size_t i = 0; i < terms.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      Numbers rest = terms;
      rest[j] = terms[i] + terms[j];
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
      for_each_order(rest, use);
    }
  }
}

/// The same for values summed in any order. `center` and `extent` are those of AabbFrame.
Exact needed_in_any_order(const BoundedPlane& p) {
  Exact most = 0;
  const auto& [normal, magnitudes, offset, farther] = p.filter;
  for (const auto& [low, high] : kIntervals) {
    const TracedNumber from = A::difference(low, 0), to = A::difference(high, 0), center = to + from, extent = to - from;
    Numbers middle{2 * offset}, spread;
    for (int k = 0; k < 3; ++k) {
      middle.push_back(normal[k] * center);
      spread.push_back(magnitudes[k] * extent);
    }
    const double truth = 2 * (offset + std::max(sum(normal) * low, sum(normal) * high));
    const TracedNumber error = kernel::AabbFrame<A>({uniform(low), uniform(high)}, {}).error(p.bound);
    for_each_order(middle, [&](const TracedNumber& m) {
      for_each_order(spread, [&](const TracedNumber& s) { most = std::max(most, needed(m + s, truth, error)); });
    });
  }
  return most;
}

/// How large kPlaneError must be for planes with a normal and no offset, and kOffsetError for planes with an offset alone.
Exact over_normals(const std::function<Exact(const BoundedPlane&)>& use) {
  Exact most = 0;
  for_each_normal([&](const Vec3& n) { most = std::max(most, use({n, 0})); });
  return most * Exact(kernel::kPlaneError);
}
Exact over_offsets(const std::function<Exact(const BoundedPlane&)>& use) {
  return std::max(use({{}, 1}), use({{}, -1})) * Exact(kernel::kOffsetError);
}

Exact needed_by_refined(const Vec3& n, double w) {
  const Vector normal = kernel::constants<A>(n), vertex = kernel::constants<A>(uniform(1));
  const Vector normal_tail{normal.x.tail(), normal.y.tail(), normal.z.tail()};
  const TracedNumber offset = w, offset_tail = offset.tail();
  const auto [value, error, is_exact] = kernel::refined_value(normal, offset, normal_tail, offset_tail, Bound{},
                                                              TracedNumber(1), vertex, kernel::constants<A>({}));
  // The true plane is the sum of its parts.
  TracedNumber truth = TracedNumber::sum(offset, offset_tail);
  for (int k = 0; k < 3; ++k) truth = TracedNumber::sum(truth, TracedNumber::sum(normal[k], normal_tail[k]));
  // The last rounding does not change the sign. Where the value exceeds the bound, it changes the value by a factor of at
  // most 1 + u.
  const Exact off = TracedNumber::sum(value.unrounded(), -truth).most() * (1 + kRoundoff);
  return off / error.least() * Exact(kernel::kRefinedError);
}

Exact needed_by_refined() {
  Exact most = std::max(needed_by_refined({}, 1), needed_by_refined({}, -1));
  for_each_normal([&](const Vec3& n) { most = std::max(most, needed_by_refined(n, 0)); });
  return most;
}

/// h + t, with h = x. A product with a zero is that of zeros alone.
TracedTerms with_tail(double x) { return {x, TracedNumber(x).tail()}; }

Exact needed_by_product_differences() {
  Exact most = 0;
  for (const auto& [first, second] : {std::pair{1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}}) {
    for (const double sign : {1.0, -1.0}) {
      const TracedTerms a = with_tail(first), b = with_tail(first), c = with_tail(second), d = with_tail(sign * second);
      const auto exact = [](const TracedTerms& x) { return TracedNumber::sum(x.high, x.low); };
      const TracedNumber truth =
          TracedNumber::sum(TracedNumber::product(exact(a), exact(b)), -TracedNumber::product(exact(c), exact(d)));
      const auto [high, low, error] = kernel::product_difference<TracedNumber>(a, b, c, d);
      const Exact off = TracedNumber::sum(TracedNumber::sum(high, low), -truth).most();
      most = std::max(most, Exact(off / error.least() * Exact(kernel::kProductDifferenceError)));
    }
  }
  return most;
}

Exact needed_by_half_spaces() {
  Exact most = 0;
  for_each_normal([&](const Vec3& n) {
    Numbers products, magnitudes;
    for (int k = 0; k < 3; ++k) {
      products.push_back(TracedNumber(n[k]) * TracedNumber(1));
      magnitudes.push_back(fabs(products.back()));
    }
    for_each_order(products, [&](const TracedNumber& s) {
      for_each_order(magnitudes, [&](const TracedNumber& magnitude) {
        most = std::max(most, needed(s, sum(n), TracedNumber(1) * magnitude));
      });
    });
  });
  return most;
}

/// CoarseFrame of shadow_block.cpp: floats, summed as in batches. Coefficients and coordinates are rounded to floats, those
/// of coordinates once more in doubles.
struct TracingFloats : BasicTracingLaneArithmetic<24> {
  static Number difference(double a, double b) {
    const TracedFloat exact = TracedFloat::sum(a, -b);
    return TracedFloat::sum(exact.rounded(), TracedFloat::product(exact.tail(), 0x1p-29));
  }
};
using FloatFrame = kernel::AabbFrame<TracingFloats>;
using Float = TracingFloats::Number;

/// The error of a plane's values, as a share of its coefficient's magnitude.
Exact needed_by_floats(const Vec3& n, double offset) {
  Exact most = 0;
  for (const auto& [low, high] : kIntervals) {
    const FloatFrame frame({uniform(low), uniform(high)}, {});
    const auto in_float = [](double x) { return Float(TracedFloat(x).rounded()); };
    const Float x = in_float(n.x), y = in_float(n.y), z = in_float(n.z);
    const auto extremes = frame.extremes({x, y, z}, {fabs(x), fabs(y), fabs(z)}, in_float(2 * offset));
    const double at_low = sum(n) * low, at_high = sum(n) * high;
    const auto off = [](const Float& value, double truth) { return TracedFloat::sum(value, -truth).most(); };
    most = std::max({most, off(extremes.low(), 2 * (std::min(at_low, at_high) + offset)),
                     off(extremes.high(), 2 * (std::max(at_low, at_high) + offset))});
  }
  return most / 2;
}

Exact needed_by_float_normals() {
  Exact most = 0;
  for_each_normal([&](const Vec3& n) { most = std::max(most, needed_by_floats(n, 0)); });
  return most;
}
Exact needed_by_float_offsets() { return std::max(needed_by_floats({}, 1), needed_by_floats({}, -1)); }

/// What a bound in floats loses, from a slope of 1 or a base of 1 on.
Exact lost_by_float_bounds() {
  Exact most = 0;
  for (const auto& [low, high] : kIntervals) {
    const FloatFrame frame({uniform(low), uniform(high)}, {});
    for (const auto& [slope, base] : {std::pair{1.0, 0.0}, {0.0, 1.0}}) {
      const kernel::BasicFilterBound<Float> stored{TracedFloat(slope).rounded(), TracedFloat(base).rounded()};
      most = std::max(most, Exact(1 - frame.error(stored).least() / 2));
    }
  }
  return most;
}

/// Operands that are all value or all error, and whose true value is one.
using Running = kernel::BasicRunningError<TracedNumber>;
std::array<Running, 2> operands() { return {Running{1, 0}, Running{0, 1}}; }

Exact needed_by_sums() {
  Exact most = 0;
  for (const Running& a : operands()) {
    for (const Running& sum : {a + Running{}, Running{} + a, a - Running{}}) {
      most = std::max(most, needed(sum.value, 1, kernel::doubt(sum)));
    }
  }
  return most;
}

Exact needed_by_products() {
  Exact most = 0;
  for (const Running& a : operands()) {
    for (const Running& b : operands()) {
      const Running product = a * b;
      most = std::max(most, needed(product.value, 1, kernel::doubt(product)));
    }
  }
  return most;
}

/// Uncertainties of one, as a low part and as an error. The rest of the number is zero.
constexpr std::array<std::array<double, 2>, 2> kUncertainties{{{1, 0}, {0, 1}}};

/// The factor needed for a plane whose known coefficients are zero and whose true value may be one, over boxes that reach as
/// far as one.
Exact needed_by_uncertain(const Bound& bound) {
  Exact most = 0;
  for (const auto& [low, high] : kIntervals) {
    const kernel::AabbFrame<A> frame({uniform(low), uniform(high)}, {});
    most = std::max(most, needed(0, 2, frame.error(bound)));
  }
  for (std::size_t k = 0; k < 4; ++k) most = std::max(most, needed(0, 1, kernel::ObbFrame<A>(obb(k), {}).error(bound)));
  return most;
}

/// A normal that is zero except for the uncertain part of one component.
Normal uncertain_normal(int axis, const Part& left) {
  const auto component = [&](int k) { return k == axis ? left : exactly(0); };
  return {component(0), component(1), component(2)};
}

Exact needed_by_slopes() {
  Exact most = 0;
  for (const auto& [low, error] : kUncertainties) {
    for (int axis = 0; axis < 3; ++axis) {
      const Normal n = uncertain_normal(axis, {0, low, error});
      most = std::max(most, needed_by_uncertain(kernel::filter_bound(n, exactly(0))));
    }
  }
  return most;
}

Exact needed_by_bases() {
  Exact most = 0;
  for (const auto& [low, error] : kUncertainties) {
    most = std::max(most, needed_by_uncertain(kernel::filter_bound(uncertain_normal(0, exactly(0)), Part{0, low, error})));
  }
  return most;
}

Exact needed_by_uncertain_refined(const Normal& n, const Part& w) {
  const Vector zero = kernel::constants<A>({});
  Exact most = 0;
  for (const auto& [low, high] : kIntervals) {
    const kernel::AabbFrame<A> frame({uniform(low), uniform(high)}, {});
    const auto refined = kernel::refined_value(zero, TracedNumber(0), zero, TracedNumber(0),
                                               kernel::refined_uncertainty(n, w), frame.reach(), zero, zero);
    most = std::max(most, needed(refined.value, 1, refined.error));
  }
  return most;
}

Exact needed_by_refined_values() {
  const Part uncertain{0, 0, 1};
  Exact most = needed_by_uncertain_refined(uncertain_normal(0, exactly(0)), uncertain);
  for (int axis = 0; axis < 3; ++axis) {
    most = std::max(most, needed_by_uncertain_refined(uncertain_normal(axis, uncertain), exactly(0)));
  }
  return most;
}

using kernel::BoundOf;
constexpr std::array kBounds{BoundOf::running_sum, BoundOf::running_product, BoundOf::slope, BoundOf::base,
                             BoundOf::refined_value};

/// The place where a bound is computed, and the factor by which it must be multiplied there.
std::pair<const char*, Exact> needed_by(BoundOf bound) {
  switch (bound) {
    case BoundOf::running_sum:
      return {"sums with a running error", needed_by_sums()};
    case BoundOf::running_product:
      return {"products with a running error", needed_by_products()};
    case BoundOf::slope:
      return {"uncertain normals over boxes", needed_by_slopes()};
    case BoundOf::base:
      return {"uncertain offsets over boxes", needed_by_bases()};
    case BoundOf::refined_value:
      return {"uncertain refined planes", needed_by_refined_values()};
  }
  return {};
}

/// Compares the inflation needed for a bound with the roundings that the kernel counts.
Constant recomputed(BoundOf bound) {
  const auto [where, needed] = needed_by(bound);
  return {"kBoundInflation - 1", where, needed * Exact(kernel::kBoundInflation) - 1,
          Exact(kernel::rounding_error(kernel::roundings(bound))), 1};
}

}  // namespace

std::vector<Constant> recomputed_constants() {
  const Exact plane_error(kernel::kPlaneError), offset_error(kernel::kOffsetError);
  std::vector<Constant> constants{
      {"kPlaneError", "values over axis-aligned boxes", over_normals(needed_by_aabb<A>), plane_error, 1},
      {"kPlaneError", "the same in batches", over_normals(needed_by_aabb<TracingLaneArithmetic>), plane_error, 1},
      {"kPlaneError", "the same, summed in any order", over_normals(needed_in_any_order), plane_error, 1},
      {"kPlaneError", "values over oriented boxes", over_normals(needed_by_obb), plane_error, 1},
      {"kOffsetError", "values over axis-aligned boxes", over_offsets(needed_by_aabb<A>), offset_error, 1},
      {"kOffsetError", "the same in batches", over_offsets(needed_by_aabb<TracingLaneArithmetic>), offset_error, 1},
      {"kOffsetError", "the same, summed in any order", over_offsets(needed_in_any_order), offset_error, 1},
      {"kOffsetError", "values over oriented boxes", over_offsets(needed_by_obb), offset_error, 1},
      {"kRefinedError", "values of refined planes", needed_by_refined(), Exact(kernel::kRefinedError), 2},
      {"kProductDifferenceError", "normals in twice the precision", needed_by_product_differences(),
       Exact(kernel::kProductDifferenceError), 2},
      {"kHalfSpaceError", "values of half-spaces", needed_by_half_spaces(), Exact(kernel::kHalfSpaceError), 1},
      {"kCoarsePlaneError", "values over boxes in floats", needed_by_float_normals(), Exact(kernel::kCoarsePlaneError), 1,
       24},
      {"kCoarseOffsetError", "values over boxes in floats", needed_by_float_offsets(), Exact(kernel::kCoarseOffsetError), 1,
       24},
      {"kCoarseInflation - 1", "bounds in floats", lost_by_float_bounds(), Exact(kernel::kCoarseInflation) - 1, 1, 24},
  };
  std::ranges::transform(kBounds, std::back_inserter(constants), recomputed);
  return constants;
}

}  // namespace occlude::bound_check
