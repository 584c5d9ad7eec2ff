// SPDX-License-Identifier: MIT
// The two number types of the oracle, and how they decide a question: intervals first, and exact numbers when intervals are
// not enough. Both give the answer of the real numbers, so it does not matter which one gave it.
#pragma once

#include <CGAL/Interval_nt.h>
#include <CGAL/Mpzf.h>
#include <CGAL/Simple_cartesian.h>

#include "occlude/oracle/oracle.h"

namespace occlude::oracle {

/// Sums, differences and products of doubles, of any size. There are no divisions.
using Exact = CGAL::Mpzf;
using Interval = CGAL::Interval_nt_advanced;  // valid only while the thread holds a RoundUpward

/// Intervals need upward rounding. Every public function holds one of these while it works.
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

/// The sign of a number. Throws when an interval does not determine it.
template <class N>
CGAL::Sign certain_sign(const N& value) {
  return CGAL::make_certain(CGAL::sign(value));
}

/// Returns question.operator()<N>() in intervals, or in exact numbers when the intervals throw as certain_sign() does.
template <class Question>
auto decide(const Question& question) {
  try {
    return question.template operator()<Interval>();
  } catch (const CGAL::Uncertain_conversion_exception&) {
    return question.template operator()<Exact>();
  }
}

/// The sign of the real number that `expression.operator()<N>()` computes in the number type N.
template <class Expression>
CGAL::Sign sign_of(const Expression& expression) {
  const CGAL::Uncertain<CGAL::Sign> sign = CGAL::sign(Interval(expression.template operator()<Interval>()));
  return CGAL::is_certain(sign) ? CGAL::get_certain(sign) : CGAL::sign(Exact(expression.template operator()<Exact>()));
}

}  // namespace occlude::oracle
