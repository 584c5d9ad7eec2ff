// SPDX-License-Identifier: MIT
// The two number types of the oracle and the way a sign is decided with them: intervals first, rationals when they are not
// enough. Both give the sign of the real number, so an answer never depends on which of them gave it.
#pragma once

#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Simple_cartesian.h>

#include "occlude/oracle/oracle.h"

namespace occlude::oracle {

using Exact = CGAL::Exact_rational;
using Interval = CGAL::Interval_nt_advanced;  // valid only while a RoundUpward lives in the thread

/// Intervals need upward rounding; every public function holds one of these while it works.
using RoundUpward = Interval::Protector;

template <class N>
using Vector = typename CGAL::Simple_cartesian<N>::Vector_3;

template <class N>
Vector<N> vector_of(const Point& p) {
  return {N(p[0]), N(p[1]), N(p[2])};
}

/// The vector from `a` to `b`, in N.
template <class N>
Vector<N> difference(const Point& a, const Point& b) {
  return vector_of<N>(b) - vector_of<N>(a);
}

/// Sign of the real number that `expression.operator()<N>()` computes in the number type N.
template <class Expression>
CGAL::Sign sign_of(const Expression& expression) {
  const Interval approximate = expression.template operator()<Interval>();
  const CGAL::Uncertain<CGAL::Sign> sign = CGAL::sign(approximate);
  if (CGAL::is_certain(sign)) return CGAL::get_certain(sign);
  return CGAL::sign(Exact(expression.template operator()<Exact>()));
}

}  // namespace occlude::oracle
