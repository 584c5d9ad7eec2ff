// SPDX-License-Identifier: MIT
// When the box and the half-spaces have no common point, four of all these half-spaces already have none (Helly 1923). For a
// box this leaves three cases. Either one plane separates the box from the rest; or two planes do together with two faces of
// the box; or three planes do together with one face. Two planes then have a positive combination in which an axis of the
// box cancels, three have one in which two axes cancel, and that combination separates them.
#include "occlude/kernel/view_frustum.h"

#include <cstddef>

#include "arithmetic.h"
#include "vector3.h"

namespace occlude::kernel {
namespace {

/// The values of a plane over a box: the value at the first corner, and the gains along the three edges.
template <class A>
struct OverBox {
  typename A::Number corner;
  Vector3<typename A::Number> gains;
};

template <class A>
OverBox<A> over(const HalfSpace& h, const Aabb& box) {
  const auto n = constants<A>(h.normal);
  const auto extent = difference<A>(box.max, box.min);
  return {dot(n, constants<A>(box.min)) + A::constant(h.offset), {n.x * extent.x, n.y * extent.y, n.z * extent.z}};
}
template <class A>
OverBox<A> over(const HalfSpace& h, const Obb& box) {
  const auto n = constants<A>(h.normal);
  const auto along = [&](std::size_t k) { return dot(n, constants<A>(box.half_edges[k])); };
  const Vector3<typename A::Number> half{along(0), along(1), along(2)};
  const auto center = dot(n, constants<A>(box.center)) + A::constant(h.offset);
  return {center - half.x - half.y - half.z, half + half};
}

template <class A>
OverBox<A> combine(const typename A::Number& s, const OverBox<A>& a, const typename A::Number& t, const OverBox<A>& b) {
  return {s * a.corner + t * b.corner, s * a.gains + t * b.gains};
}

/// The sign at the corner of the box with the least value (`direction` = -1) or the greatest (1).
template <class A>
int extreme_sign(A& arithmetic, const OverBox<A>& f, int direction) {
  auto value = f.corner;
  for (int k = 0; k < 3; ++k) {
    if (direction * arithmetic.sign(f.gains[k]) > 0) value = value + f.gains[k];
  }
  return arithmetic.sign(value);
}

/// Sets `result` to the combination of two planes in which axis k cancels. Returns whether it is a positive combination.
template <class A>
bool cancel(A& arithmetic, int k, const OverBox<A>& a, const OverBox<A>& b, OverBox<A>& result) {
  if (arithmetic.sign(a.gains[k]) * arithmetic.sign(b.gains[k]) >= 0) return false;
  result = combine<A>(A::magnitude(b.gains[k]), a, A::magnitude(a.gains[k]), b);
  return true;
}

/// Whether the combination of three planes in which all axes but k cancel is positive and separates the box from them.
template <class A>
bool is_separated_by_three(A& arithmetic, int k, const OverBox<A>& a, const OverBox<A>& b, const OverBox<A>& c) {
  const int l = (k + 1) % 3, m = (k + 2) % 3;
  const auto weight = [&](const OverBox<A>& p, const OverBox<A>& q) {
    return p.gains[l] * q.gains[m] - p.gains[m] * q.gains[l];
  };
  const auto of_a = weight(b, c), of_b = weight(c, a), of_c = weight(a, b);
  const int sign = arithmetic.sign(of_a);
  if (sign == 0 || arithmetic.sign(of_b) != sign || arithmetic.sign(of_c) != sign) return false;
  const auto size = [](const auto& w) { return A::magnitude(w); };
  auto corner = size(of_a) * a.corner + size(of_b) * b.corner + size(of_c) * c.corner;
  const auto gain = size(of_a) * a.gains[k] + size(of_b) * b.gains[k] + size(of_c) * c.gains[k];
  if (arithmetic.sign(gain) > 0) corner = corner + gain;
  return arithmetic.sign(corner) < 0;
}

template <class Box>
class Question {
 public:
  Question(std::span<const HalfSpace> frustum, const Box& box) : frustum_(frustum), box_(box) {}

  [[nodiscard]] Decision answer() {
    bool inside = true;
    for (const HalfSpace& h : frustum_) {
      if (sign(h, 1) < 0) return {Relation::outside, stage_};
      inside = inside && sign(h, -1) >= 0;
    }
    if (inside) return {Relation::inside, stage_};
    return {is_separated() ? Relation::outside : Relation::partial, stage_};
  }

 private:
  [[nodiscard]] int sign(const HalfSpace& h, int direction) {
    return certified([&]<class A>(A& arithmetic) { return extreme_sign(arithmetic, over<A>(h, box_), direction); }, &stage_);
  }

  [[nodiscard]] bool is_separated_by(const HalfSpace& a, const HalfSpace& b) {
    const auto question = [&]<class A>(A& arithmetic) {
      const auto f = over<A>(a, box_), g = over<A>(b, box_);
      OverBox<A> both;
      for (int k = 0; k < 3; ++k) {
        if (cancel(arithmetic, k, f, g, both) && extreme_sign(arithmetic, both, 1) < 0) return true;
      }
      return false;
    };
    return certified(question, &stage_);
  }

  [[nodiscard]] bool is_separated_by(const HalfSpace& a, const HalfSpace& b, const HalfSpace& c) {
    const auto question = [&]<class A>(A& arithmetic) {
      const auto f = over<A>(a, box_), g = over<A>(b, box_), h = over<A>(c, box_);
      return is_separated_by_three(arithmetic, 0, f, g, h) || is_separated_by_three(arithmetic, 1, f, g, h) ||
             is_separated_by_three(arithmetic, 2, f, g, h);
    };
    return certified(question, &stage_);
  }

  [[nodiscard]] bool is_separated() {
    for (std::size_t i = 0; i < frustum_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (is_separated_by(frustum_[i], frustum_[j])) return true;
        for (std::size_t k = 0; k < j; ++k) {
          if (is_separated_by(frustum_[i], frustum_[j], frustum_[k])) return true;
        }
      }
    }
    return false;
  }

  std::span<const HalfSpace> frustum_;
  const Box& box_;
  Stage stage_ = Stage::filter;
};

}  // namespace

Decision overlap_certified(std::span<const HalfSpace> frustum, const Aabb& box) { return Question(frustum, box).answer(); }
Decision overlap_certified(std::span<const HalfSpace> frustum, const Obb& box) { return Question(frustum, box).answer(); }

}  // namespace occlude::kernel
