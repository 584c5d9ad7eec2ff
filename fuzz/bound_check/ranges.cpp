// SPDX-License-Identifier: MIT
#include "ranges.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "box_plane.h"
#include "cases/ask.h"
#include "occlude/fuzz/cases.h"
#include "occlude/fuzz/random.h"
#include "profile.h"
#include "segment_clip.h"

namespace occlude::bound_check {
namespace {

using kernel::PlaneRecipe;

constexpr double kMantissa = 53;                    // bits of a double
constexpr double kLeast = -100, kGreatest = 100;    // legal magnitudes, from the contract
constexpr double kUnit = kLeast - (kMantissa - 1);  // the last bit of the smallest
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The extent of all numbers made since it was last cleared.
Extent seen;

/// The exponent of 2^a + 2^b.
double top_of_sum(double a, double b) {
  const double larger = std::max(a, b);
  return larger == -kInfinity ? larger : larger + std::log2(1 + std::exp2(std::min(a, b) - larger));
}

/// A number of which only exponents of two are known.
class RangedNumber {
 public:
  RangedNumber() = default;
  /// An exact number.
  RangedNumber(double unit, double least, double top) : RangedNumber({unit, least, top, kInfinity, kInfinity}) {}

  [[nodiscard]] Extent extent() const { return {unit_, top_, std::min(error_, error_of_zero_)}; }
  [[nodiscard]] RangedNumber rounded() const { return {{unit_, least_, top_, error_alone(), error_of_zero_}}; }
  [[nodiscard]] RangedNumber scaled(double least, double most) const {
    return {{unit_ + least, least_ + least, top_ + most, error_ + least, error_of_zero_ + least}};
  }

  RangedNumber operator-() const { return *this; }
  friend RangedNumber operator+(const RangedNumber& a, const RangedNumber& b) {
    if (a.is_zero()) return b.rounded();
    if (b.is_zero()) return a.rounded();
    const double unit = std::min(a.unit_, b.unit_);
    // The sum of two exact numbers has only the error of its own rounding. Otherwise it has at least the error of one of
    // them.
    const bool are_exact = a.error_ == kInfinity && b.error_ == kInfinity;
    const double brought = are_exact ? -kInfinity : std::min(a.error_alone(), b.error_alone());
    return {{unit, unit, top_of_sum(a.top_, b.top_), std::max(unit - kMantissa, brought),
             std::min({a.error_of_zero_, b.error_of_zero_, a.error_, b.error_})}};
  }
  friend RangedNumber operator-(const RangedNumber& a, const RangedNumber& b) { return a + b; }
  /// A product is zero only where a factor is, and then its error comes only from the error of that factor.
  friend RangedNumber operator*(const RangedNumber& a, const RangedNumber& b) {
    const double least = a.least_ + b.least_;
    return {{a.unit_ + b.unit_, least, a.top_ + b.top_, least - kMantissa,
             std::min({a.least_ + b.error_of_zero_, b.least_ + a.error_of_zero_, a.error_of_zero_ + b.error_of_zero_})}};
  }

 private:
  struct Exponents {
    double unit, least, top, error, error_of_zero;
  };
  RangedNumber(const Exponents& e)
      : unit_(e.unit), least_(e.least), top_(e.top), error_(e.error), error_of_zero_(e.error_of_zero) {
    seen.include(extent());
  }

  [[nodiscard]] bool is_zero() const { return top_ == -kInfinity; }
  [[nodiscard]] double error_alone() const { return error_ == kInfinity ? least_ - kMantissa : error_; }

  // All are exponents of two.
  double unit_ = kInfinity;                               ///< the number is a multiple of this,
  double least_ = kInfinity;                              ///< zero or at least this in magnitude,
  double top_ = -kInfinity;                               ///< and at most this
  double error_ = kInfinity, error_of_zero_ = kInfinity;  ///< the least error when it is not zero and when it is; or none
};

/// Every coordinate stands for all legal ones. Only 0, 1 and -1 stand for themselves, because they are the coordinates of
/// the axes. Signs are random.
class RangedArithmetic {
 public:
  using Number = RangedNumber;
  explicit RangedArithmetic(fuzz::Random& random) : random_(random) {}

  static RangedNumber constant(double x) {
    if (x == 0) return {};
    return std::fabs(x) == 1 ? RangedNumber(0, 0, 0) : RangedNumber(kUnit, kLeast, kGreatest);
  }
  static RangedNumber difference(double a, double b) {
    const auto is_of_axis = [](double x) { return x == 0 || std::fabs(x) == 1; };
    if (is_of_axis(a) && is_of_axis(b)) return constant(a) + constant(b);
    return RangedNumber(kUnit, kUnit, kGreatest + 1).rounded();
  }
  static RangedNumber magnitude(const RangedNumber& x) { return x; }
  int sign(const RangedNumber&) { return random_.integer(-1, 1); }

 private:
  fuzz::Random& random_;
};
using A = RangedArithmetic;
using Coefficients = kernel::PlaneCoefficients<A>;

RangedNumber at_any_point(const Coefficients& plane) {
  const RangedNumber coordinate = A::difference(2, 3);
  return dot(plane.normal, {coordinate, coordinate, coordinate}) + plane.offset;
}

/// The plane as rounded_plane.cpp scales it. Its slope is at least u |n|, at least the error of a component, and less than 8
/// u times the sum of magnitudes.
Coefficients stored(const Coefficients& plane) {
  const auto& [x, y, z] = plane.normal;
  const Extent n = (x + y + z).extent();
  const double least = kMantissa - (n.top + 3), greatest = -std::min(n.unit - kMantissa, n.error);
  const auto component = [&](const RangedNumber& k) { return k.scaled(least, kMantissa - k.extent().top); };
  return {{component(x), component(y), component(z)}, plane.offset.scaled(least, greatest)};
}

/// Evaluates what the kernel computes for the frustum and the box of a case, each kind of expression separately.
class Survey {
 public:
  explicit Survey(fuzz::Random& random) : arithmetic_(random) {}

  void include(const fuzz::Case& made) {
    const auto result = fuzz::make_frustum(made);
    if (!result.frustum) return;
    const kernel::StoredFrustum& frustum = *kernel::stored(*result.frustum);
    for (const PlaneRecipe& recipe : frustum.recipes) {
      Coefficients plane;
      survey(coefficients_, [&] { plane = kernel::coefficients<A>(frustum, recipe); });
      survey(stored_, [&] { plane = stored(plane); });
      survey(stored_values_, [&] { at_any_point(plane); });
    }
    std::visit([&](const auto& box) { include_values(frustum, box); }, made.box);
    survey(clips_, [&] { compare_clips(frustum); });
    survey(thirds_, [&] { combine_three(); });
  }

  [[nodiscard]] std::vector<Expressions> result() const {
    return {{"coefficients of stored planes", coefficients_},
            {"the same, scaled", stored_},
            {"their values", stored_values_},
            {"planes, unscaled, over boxes", values_},
            {"clip parameters compared", clips_},
            {"three half-spaces combined", thirds_}};
  }

 private:
  template <class Work>
  static void survey(Extent& into, const Work& work) {
    seen = {};
    work();
    into.include(seen);
  }

  void include_values(const kernel::StoredFrustum& frustum, const kernel::Aabb& box) {
    survey(values_, [&] {
      for (const PlaneRecipe& recipe : frustum.recipes) value_over(frustum, recipe, box);
    });
  }
  void include_values(const kernel::StoredFrustum& frustum, const kernel::Obb& box) {
    survey(values_, [&] {
      const auto sign_along = [&](std::size_t, std::size_t) { return arithmetic_.sign({}); };
      const auto look = [&](const PlaneRecipe& recipe) {
        value_over(frustum, recipe, box);
        return false;
      };
      static_cast<void>(kernel::visit_profile(frustum, {box.half_edges, false}, sign_along, look));
    });
  }
  template <class Box>
  void value_over(const kernel::StoredFrustum& frustum, const PlaneRecipe& recipe, const Box& box) {
    const auto plane = kernel::coefficients<A>(frustum, recipe);
    static_cast<void>(kernel::extremal_sign(arithmetic_, plane, frustum.origin, box, 1));
  }

  /// An edge clipped by the planes of a polytope: where degree six is reached, as for the union of two shadows.
  void compare_clips(const kernel::StoredFrustum& frustum) {
    kernel::SegmentClip<A> left(arithmetic_);
    for (std::size_t i = 0; i < frustum.plane_count; ++i) {
      const auto value = at_any_point(kernel::coefficients<A>(frustum, frustum.recipes[i]));
      left.clip(value, value + value);
      static_cast<void>(left.empty());
    }
  }

  /// The expressions of view_frustum.cpp: gains along the half edges of a box, and their determinants times the value at a
  /// corner.
  static void combine_three() {
    const RangedNumber x = A::constant(2);
    const RangedNumber along = kernel::dot<RangedNumber>({x, x, x}, {x, x, x}), gain = along + along;
    const RangedNumber corner = along + x - along - along - along, weight = gain * gain - gain * gain;
    static_cast<void>(weight * corner + weight * corner + weight * corner + (weight * gain + weight * gain + weight * gain));
  }

  RangedArithmetic arithmetic_;
  Extent coefficients_, stored_, stored_values_, values_, clips_, thirds_;
};

}  // namespace

void Extent::include(const Extent& other) {
  unit = std::min(unit, other.unit);
  top = std::max(top, other.top);
  error = std::min(error, other.error);
}

bool Extent::is_safe() const {
  constexpr double kSplit = 28;  // two_product() multiplies by little more than 2^27
  using Double = std::numeric_limits<double>;
  return unit >= Double::min_exponent - 1 && error >= Double::min_exponent - 1 && top + kSplit < Double::max_exponent;
}

std::vector<Expressions> ranges() {
  constexpr int kCases = 20;
  fuzz::Random random(1);
  Survey survey(random);
  for (const fuzz::Family family : fuzz::families()) {
    for (int i = 0; i < kCases; ++i) survey.include(fuzz::make_case(family, random.bits()));
  }
  return survey.result();
}

}  // namespace occlude::bound_check
