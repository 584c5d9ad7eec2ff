// SPDX-License-Identifier: MIT
// A plane defined by exact numbers, and the side of it on which a point lies.
#pragma once

#include <optional>
#include <type_traits>
#include <vector>

#include "numbers.h"

namespace occlude::oracle {

/// The closed half-space normal . (x - point) + offset >= 0.
template <class N>
struct HalfSpace {
  Vector<N> normal;
  Vector<N> point;
  N offset = N(0);

  /// Positive inside, zero on the plane, negative outside.
  [[nodiscard]] N height(const Point& x) const { return normal * (vector_of<N>(x) - point) + offset; }
};

/// The half-space that `definition.operator()<N>()` builds in the number type N: in intervals at once, exactly when first
/// needed, and kept. Points that a definition passes_through lie on the plane by what it is; the rest is computed.
template <class Definition>
class Plane {
 public:
  explicit Plane(const Definition& definition)
      : definition_(definition), approximate_(definition.template operator()<Interval>()) {}

  /// Sign of the height of `x`, exact.
  CGAL::Sign side(const Point& x) {
    if constexpr (requires { definition_.passes_through(x); }) {
      if (definition_.passes_through(x)) return CGAL::ZERO;
    }
    const CGAL::Uncertain<CGAL::Sign> sign = CGAL::sign(approximate_.height(x));
    return CGAL::is_certain(sign) ? CGAL::get_certain(sign) : CGAL::sign(exact().height(x));
  }

  /// The half-space in the number type N.
  template <class N>
  const HalfSpace<N>& in() {
    if constexpr (std::is_same_v<N, Interval>) {
      return approximate_;
    } else {
      return exact();
    }
  }

 private:
  const HalfSpace<Exact>& exact() {
    if (!exact_) exact_ = definition_.template operator()<Exact>();
    return *exact_;
  }

  Definition definition_;
  HalfSpace<Interval> approximate_;
  std::optional<HalfSpace<Exact>> exact_;
};

/// The side of the plane on which all the points lie that are not on it: ZERO when there are none on either side, or some on
/// both.
template <class Definition>
CGAL::Sign side_of_all(const Definition& definition, const std::vector<Point>& points) {
  Plane plane(definition);
  CGAL::Sign all = CGAL::ZERO;
  for (const Point& point : points) {
    const CGAL::Sign side = plane.side(point);
    if (side == CGAL::ZERO) continue;
    if (side == -all) return CGAL::ZERO;
    all = side;
  }
  return all;
}

}  // namespace occlude::oracle
