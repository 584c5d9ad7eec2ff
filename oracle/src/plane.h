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
  [[nodiscard]] N height(const Vector<N>& x) const { return normal * (x - point) + offset; }
  [[nodiscard]] N height(const Point& x) const { return height(vector_of<N>(x)); }
};

/// The half-space that `definition.operator()<N>()` builds in the number type N. It is built in intervals at once, and in
/// exact numbers when they are first needed. Both are kept. A definition may name points with passes_through(). They lie on
/// the plane by construction, so nothing is computed for them.
template <class Definition>
class Plane {
 public:
  explicit Plane(const Definition& definition)
      : definition_(definition), approximate_(definition.template operator()<Interval>()) {}

  /// The exact sign of the height of `x`.
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

/// The side of the plane on which all points lie that are not on the plane. ZERO when there are points on both sides or on
/// neither.
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
