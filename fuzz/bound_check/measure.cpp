// SPDX-License-Identifier: MIT
#include "measure.h"

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "box_plane.h"
#include "cases/ask.h"
#include "coarse_plane.h"
#include "error_bounds.h"
#include "float_lane.h"
#include "occlude/fuzz/cases.h"
#include "occlude/fuzz/random.h"
#include "profile.h"
#include "rounded_plane.h"
#include "true_plane.h"

namespace occlude::bound_check {
namespace {

using kernel::PlaneRecipe;
using kernel::Vec3;

Exact distance(const Exact& a, const Exact& b) { return CGAL::abs(a - b); }

using Twice = kernel::DoubleDoubleArithmetic;

/// The power of two by which the kernel has scaled a plane, or 0 when all its coefficients are zero.
Exact scale_of(const kernel::FilterPlane& filter, const kernel::PlaneCoefficients<Twice>& plane) {
  for (int k = 0; k < 3; ++k) {
    if (filter.normal[k] != 0) return Exact(filter.normal[k] / plane.normal[k].high);
  }
  return Exact(filter.offset == 0 ? 0 : filter.offset / plane.offset.high);
}

/// An arithmetic that keeps the last number whose sign was asked for, which is the value that a question was about.
template <class A>
struct Remembering : A {
  typename A::Number last{};

  int sign(const typename A::Number& x) {
    last = x;
    return A::sign(x);
  }
};

double share_of(const kernel::RunningError& x, const Exact& truth) {
  return share(distance(Exact(x.value), truth), x.error);
}
double share_of(const kernel::DoubleDouble& x, const Exact& truth) {
  return share(distance(Exact(x.high) + Exact(x.low.value), truth), x.low.error);
}

template <class Box>
class Measurement {
 public:
  Measurement(const kernel::StoredFrustum& frustum, const Box& box, fuzz::Random& random, Shares& shares)
      : frustum_(frustum), box_(box), random_(random), shares_(shares) {}

  void run() {
    const std::size_t planes = frustum_.plane_count, stored = frustum_.recipes.size();
    const std::size_t i = random_.index(planes);
    measure_stored(i, Kind::frustum_plane);
    measure_half_space(frustum_.filter_planes[i]);
    measure_pair(i, random_.index(planes));
    if constexpr (kIsAligned) {
      if (stored > planes) measure_stored(planes + random_.index(stored - planes), Kind::profile_plane);
    } else {
      measure_own_profile();
    }
  }

 private:
  static constexpr bool kIsAligned = std::is_same_v<Box, kernel::Aabb>;
  using Frame =
      std::conditional_t<kIsAligned, kernel::AabbFrame<kernel::PlainArithmetic>, kernel::ObbFrame<kernel::PlainArithmetic>>;

  /// Measures a plane that the frustum stores in doubles: by the filter, by the arithmetics that bound their errors as they
  /// go, and by the refined plane.
  void measure_stored(std::size_t i, Kind kind) {
    const PlaneRecipe& recipe = frustum_.recipes[i];
    const TruePlane truth = true_plane(frustum_, recipe);
    const Range range = values(truth, box_);
    measure_expression(recipe, range.high);
    const kernel::FilterPlane& filter = frustum_.filter_planes[i];
    const auto twice = kernel::coefficients<Twice>(frustum_, recipe);
    const Exact scale = scale_of(filter, twice);
    const Frame frame(box_, frustum_.origin);
    const auto extremes = frame.extremes(filter);
    // The plane's own bound is taken because that of the frustum is the largest of all planes.
    const double error = frame.error(kernel::rounded(twice).bound);
    const Exact unit = kIsAligned ? 2 * scale : scale;  // AabbFrame doubles all values
    shares_.note(kind, share(distance(Exact(extremes.low()), unit * range.low), error));
    shares_.note(kind, share(distance(Exact(extremes.high()), unit * range.high), error));
    if constexpr (kIsAligned) {
      measure_refined(i, truth, scale, frame.reach());
      const kernel::FilterBound bound = kernel::rounded(twice).bound;
      measure_floats<true>(filter, bound, {unit * range.low, unit * range.high});
      measure_floats<false>(filter, bound, {unit * range.low, unit * range.high});
    }
  }

  /// The same in floats, as shadow_block.cpp computes it. Where a value exceeds the bound of floats, that in doubles must
  /// exceed its own. So twice the bound of doubles is taken off.
  template <bool kIsFused>
  void measure_floats(const kernel::FilterPlane& filter, const kernel::FilterBound& filter_bound, const Range& truth) {
    kernel::CoarseBound bound;
    const kernel::CoarsePlane plane = kernel::coarse(filter, filter_bound, bound);
    using Number = FloatLane<kIsFused>;
    const kernel::AabbFrame<FloatArithmetic<kIsFused>> floats(box_, frustum_.origin);
    const Number twice_reach = floats.reach() + floats.reach();
    if (!std::isfinite(bound.twice_base) || !(twice_reach.value < 2 * kernel::kCoarseReach)) return;  // left to doubles
    const Number error = multiply_add(bound.slope, twice_reach, bound.twice_base);
    const auto magnitude = [](float x) { return Number(std::fabs(x)); };
    const auto extremes = floats.extremes({plane.x, plane.y, plane.z},
                                          {magnitude(plane.x), magnitude(plane.y), magnitude(plane.z)}, plane.twice_offset);
    const Exact of_doubles = 2 * Exact(Frame(box_, frustum_.origin).error(filter_bound));
    const auto note = [&](Number value, const Exact& true_value) {
      shares_.note(Kind::floats, share(distance(Exact(value.value), true_value), error.value - of_doubles));
    };
    note(extremes.low(), truth.low);
    note(extremes.high(), truth.high);
  }

  void measure_refined(std::size_t i, const TruePlane& truth, const Exact& scale, double reach) {
    const kernel::FilterPlane& filter = frustum_.filter_planes[i];
    const kernel::RefinedPlane& tail = frustum_.refined_planes[i];
    const auto bit = [&] { return random_.chance(0.5); };
    const bool x = bit(), y = bit(), z = bit();
    const Vec3 vertex = kernel::extremal_vertex(box_, x, y, z);
    const auto real = [](const Vec3& v) { return kernel::constants<kernel::PlainArithmetic>(v); };
    const auto refined = kernel::refined_value(real(filter.normal), filter.offset, real(tail.normal), tail.offset,
                                               tail.uncertainty, reach, real(vertex), real(frustum_.origin));
    // The last rounding does not change the sign.
    const Exact off = distance(Exact(refined.value), scale * truth.at(vertex)) - kRoundoff * CGAL::abs(Exact(refined.value));
    shares_.note(Kind::refined, share(off, refined.is_exact ? 0 : refined.error));
  }

  /// Measures the value at the vertex of the box farthest along the normal, in the arithmetics that bound their errors as
  /// they go.
  void measure_expression(const PlaneRecipe& recipe, const Exact& truth) {
    note<Remembering<kernel::FilterArithmetic>>(Kind::running_error, recipe, truth);
    note<Remembering<Twice>>(Kind::double_double, recipe, truth);
  }

  template <class A>
  void note(Kind kind, const PlaneRecipe& recipe, const Exact& truth) {
    A arithmetic;
    const auto plane = kernel::coefficients<A>(frustum_, recipe);
    static_cast<void>(kernel::extremal_sign(arithmetic, plane, frustum_.origin, box_, 1));
    // In doubt about the normal it may have asked about another vertex.
    if (kIsAligned && arithmetic.failed()) return;
    shares_.note(kind, share_of(arithmetic.last, truth));
  }

  void measure_own_profile() {
    if constexpr (!kIsAligned) {
      std::vector<PlaneRecipe> recipes;
      const auto sign_along = [&](std::size_t plane, std::size_t k) {  // rounded: which planes come of it is no matter
        const Vec3 &n = frustum_.filter_planes[plane].normal, &h = box_.half_edges[k];
        return kernel::PlainArithmetic::sign(n.x * h.x + n.y * h.y + n.z * h.z);
      };
      const auto keep = [&](const PlaneRecipe& recipe) {
        recipes.push_back(recipe);
        return false;
      };
      static_cast<void>(kernel::visit_profile(frustum_, {box_.half_edges, false}, sign_along, keep));
      if (recipes.empty()) return;
      const PlaneRecipe& recipe = recipes[random_.index(recipes.size())];
      measure_expression(recipe, values(true_plane(frustum_, recipe), box_).high);
    }
  }

  /// An expression of degree six: it compares the values of two planes at two points.
  void measure_pair(std::size_t i, std::size_t j) {
    const PlaneRecipe &f = frustum_.recipes[i], &g = frustum_.recipes[j];
    const TruePlane true_f = true_plane(frustum_, f), true_g = true_plane(frustum_, g);
    const auto [p, q] = two_points(box_);
    const Exact truth = true_f.at(p) * true_g.at(q) - true_f.at(q) * true_g.at(p);
    shares_.note(Kind::running_error, share_of(crossed<kernel::FilterArithmetic>(f, g, p, q), truth));
    shares_.note(Kind::double_double, share_of(crossed<Twice>(f, g, p, q), truth));
  }

  template <class A>
  [[nodiscard]] typename A::Number crossed(const PlaneRecipe& f, const PlaneRecipe& g, const Vec3& p, const Vec3& q) const {
    const auto at = [&](const PlaneRecipe& recipe, const Vec3& x) {
      const auto plane = kernel::coefficients<A>(frustum_, recipe);
      return dot(plane.normal, kernel::difference<A>(x, frustum_.origin)) + plane.offset;
    };
    return at(f, p) * at(g, q) - at(f, q) * at(g, p);
  }

  static std::pair<Vec3, Vec3> two_points(const kernel::Aabb& box) { return {box.min, box.max}; }
  static std::pair<Vec3, Vec3> two_points(const kernel::Obb& box) { return {box.center, box.half_edges[0]}; }

  /// The sum of products of a half-space with the plane's normal, before the offset is added, as half_space.cpp computes it.
  void measure_half_space(const kernel::FilterPlane& plane) {
    const Vec3 x = two_points(box_).first;
    const double px = plane.normal.x * x.x, py = plane.normal.y * x.y, pz = plane.normal.z * x.z;
    const Exact off = distance(Exact(px + py + pz), vector_of(plane.normal) * vector_of(x));
    shares_.note(Kind::half_space, share(off, kernel::kHalfSpaceError * (std::fabs(px) + std::fabs(py) + std::fabs(pz))));
  }

  const kernel::StoredFrustum& frustum_;
  const Box& box_;
  fuzz::Random& random_;
  Shares& shares_;
};

}  // namespace

void Shares::note(Kind kind, double share) {
  double& most = largest[static_cast<std::size_t>(kind)];
  most = std::max(most, share);
}

void Shares::include(const Shares& other) {
  for (std::size_t k = 0; k < largest.size(); ++k) largest[k] = std::max(largest[k], other.largest[k]);
  legal_cases += other.legal_cases;
}

Shares measure(fuzz::Family family, int cases, std::uint64_t seed) {
  Shares shares;
  fuzz::Random random(seed);
  for (int i = 0; i < cases; ++i) {
    const fuzz::Case made = fuzz::make_case(family, random.bits());
    const auto result = fuzz::make_frustum(made);
    if (!result.frustum || fuzz::check(made.box) != kernel::Refusal::none) continue;
    ++shares.legal_cases;
    std::visit([&](const auto& box) { Measurement(*kernel::stored(*result.frustum), box, random, shares).run(); }, made.box);
  }
  return shares;
}

}  // namespace occlude::bound_check
