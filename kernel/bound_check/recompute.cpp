// SPDX-License-Identifier: MIT
// Every error here is a sum of magnitudes of expressions that are linear in the coefficients of the plane, and linear in the
// coordinates; its bound is the product of a norm of each. So the error is a convex function on the set of all planes and
// boxes of norms at most one, and is largest at a corner of that set: a few planes and boxes are enough.
#include "recompute.h"

#include <algorithm>
#include <functional>

#include "box_frame.h"
#include "error_bounds.h"
#include "rounded_plane.h"
#include "running_error.h"
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

/// By how much a bound must be multiplied to hold: without end when it may be zero.
Exact needed(const TracedNumber& computed, double truth, const TracedNumber& bound) {
  if (bound.least() <= 0) return Exact(std::numeric_limits<double>::max());
  return largest_error(computed, truth) / bound.least();
}

Vec3 along(int axis, double x) {
  Vec3 v;
  v[axis] = x;
  return v;
}

kernel::FilterPlane plane(const Vec3& n, double offset) {
  return {n, {std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)}, offset, {}};
}

/// The normals at the corners of the set of planes.
void for_each_normal(const std::function<void(const Vec3&)>& use) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) use(along(axis, sign));
  }
}

/// Bounds of boxes, the same on each axis, at the corners of the set of those that reach as far as one.
constexpr std::array<std::array<double, 2>, 3> kIntervals{{{1, 1}, {-1, 1}, {-1, -1}}};

Vec3 uniform(double x) { return {x, x, x}; }

double sum(const Vec3& v) { return v.x + v.y + v.z; }

/// Values of a plane over a box at both extremal vertices; the true ones are known.
template <class Frame>
Exact needed_for(const Frame& frame, const kernel::FilterPlane& p, const kernel::FilterBound& bound, double true_low,
                 double true_high) {
  const auto extremes = frame.extremes(p);
  const TracedNumber error = frame.error(bound);
  return std::max(needed(extremes.low(), true_low, error), needed(extremes.high(), true_high, error));
}

Exact needed_by_aabb(const kernel::FilterPlane& p, const kernel::FilterBound& bound) {
  Exact most = 0;
  for (const auto& [low, high] : kIntervals) {
    const kernel::AabbFrame<A> frame({uniform(low), uniform(high)}, {});
    const double at_low = sum(p.normal) * low, at_high = sum(p.normal) * high;
    most = std::max(most, needed_for(frame, p, bound, 2 * (std::min(at_low, at_high) + p.offset),
                                     2 * (std::max(at_low, at_high) + p.offset)));
  }
  return most;
}

/// All of the reach is the centre's, or that of one half edge.
Exact needed_by_obb(const kernel::FilterPlane& p, const kernel::FilterBound& bound) {
  Exact most = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    kernel::Obb box;
    (k < 3 ? box.half_edges[k] : box.center) = uniform(1);
    const double center = p.offset + (k < 3 ? 0 : sum(p.normal)), spread = k < 3 ? std::fabs(sum(p.normal)) : 0;
    most = std::max(most, needed_for(kernel::ObbFrame<A>(box, {}), p, bound, center - spread, center + spread));
  }
  return most;
}

/// The sums of numbers in all orders.
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

/// The same values with their sums in any order, as batches and compilers may have it. `center` and `extent` are those of
/// AabbFrame.
Exact needed_in_any_order(const kernel::FilterPlane& p) {
  Exact most = 0;
  for (const auto& [low, high] : kIntervals) {
    const TracedNumber from = A::difference(low, 0), to = A::difference(high, 0), center = to + from, extent = to - from;
    Numbers middle{2 * p.offset}, spread;
    for (int k = 0; k < 3; ++k) {
      middle.push_back(p.normal[k] * center);
      spread.push_back(p.magnitudes[k] * extent);
    }
    const double truth = 2 * (p.offset + std::max(sum(p.normal) * low, sum(p.normal) * high));
    for_each_order(middle, [&](const TracedNumber& m) {
      for_each_order(spread, [&](const TracedNumber& s) {
        // The bound is rounded as the kernel's: in the reach, in a product and a sum.
        most = std::max(most, needed(m + s, truth, TracedNumber(1) * (fabs(center) + extent) + TracedNumber(0)));
      });
    });
  }
  return most;
}

/// The largest that `use` returns for the planes with a normal.
Exact over_normals(const std::function<Exact(const kernel::FilterPlane&)>& use) {
  Exact most = 0;
  for_each_normal([&](const Vec3& n) { most = std::max(most, use(plane(n, 0))); });
  return most;
}

/// And for those without, all offset.
Exact over_offsets(const std::function<Exact(const kernel::FilterPlane&)>& use) {
  return std::max(use(plane({}, 1)), use(plane({}, -1)));
}

Exact needed_by_refined(const Vec3& n, double w) {
  const Vector normal = kernel::constants<A>(n), vertex = kernel::constants<A>(uniform(1));
  const Vector normal_tail{normal.x.tail(), normal.y.tail(), normal.z.tail()};
  const TracedNumber offset = w, offset_tail = offset.tail();
  const auto [value, error, is_exact] =
      kernel::refined_value(normal, offset, normal_tail, offset_tail, TracedNumber(0), vertex, kernel::constants<A>({}));
  // The plane is what its parts are together.
  TracedNumber truth = TracedNumber::sum(offset, offset_tail);
  for (int k = 0; k < 3; ++k) truth = TracedNumber::sum(truth, TracedNumber::sum(normal[k], normal_tail[k]));
  // The last rounding leaves the sign alone and, where the value exceeds the bound, one part in 1 / u of it.
  const Exact off = TracedNumber::sum(value.unrounded(), -truth).most() * (1 + kRoundoff);
  return off / error.least() * Exact(kernel::kRefinedError);
}

Exact needed_by_refined() {
  Exact most = std::max(needed_by_refined({}, 1), needed_by_refined({}, -1));
  for_each_normal([&](const Vec3& n) { most = std::max(most, needed_by_refined(n, 0)); });
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

/// Operands that are all value or all error, and one in truth.
using Running = kernel::BasicRunningError<TracedNumber>;
std::array<Running, 2> operands() { return {Running{1, 0}, Running{0, 1}}; }

Exact needed_by_sums() {
  Exact most = 0;
  for (const Running& a : operands()) {
    for (const Running& sum : {a + Running{}, Running{} + a, a - Running{}}) {
      most = std::max(most, needed(sum.value, 1, sum.error));
    }
  }
  return most * Exact(kernel::kBoundInflation);
}

Exact needed_by_products() {
  Exact most = 0;
  for (const Running& a : operands()) {
    for (const Running& b : operands()) {
      const Running product = a * b;
      most = std::max(most, needed(product.value, 1, product.error));
    }
  }
  return most * Exact(kernel::kBoundInflation);
}

}  // namespace

std::vector<Constant> recomputed_constants() {
  const Exact plane_error(kernel::kPlaneError), offset_error(kernel::kOffsetError), inflation(kernel::kBoundInflation);
  const kernel::FilterBound slope{.slope = 1, .base = 0}, base{.slope = 0, .base = 1};
  const auto aabb = [](const auto& bound) { return [&](const auto& p) { return needed_by_aabb(p, bound); }; };
  const auto obb = [](const auto& bound) { return [&](const auto& p) { return needed_by_obb(p, bound); }; };
  return {
      {"kPlaneError", "values over axis-aligned boxes", over_normals(aabb(slope)), plane_error, 1},
      {"kPlaneError", "the same, summed in any order", over_normals(needed_in_any_order), plane_error, 1},
      {"kPlaneError", "values over oriented boxes", over_normals(obb(slope)), plane_error, 1},
      {"kOffsetError", "values over axis-aligned boxes", over_offsets(aabb(base)), offset_error, 1},
      {"kOffsetError", "the same, summed in any order", over_offsets(needed_in_any_order), offset_error, 1},
      {"kOffsetError", "values over oriented boxes", over_offsets(obb(base)), offset_error, 1},
      {"kRefinedError", "values of refined planes", needed_by_refined(), Exact(kernel::kRefinedError), 2},
      {"kHalfSpaceError", "values of half-spaces", needed_by_half_spaces(), Exact(kernel::kHalfSpaceError), 1},
      {"kBoundInflation - 1", "sums with a running error", needed_by_sums() - 1, inflation - 1, 1},
      {"kBoundInflation - 1", "products with a running error", needed_by_products() - 1, inflation - 1, 1},
  };
}

}  // namespace occlude::bound_check
