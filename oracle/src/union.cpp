// SPDX-License-Identifier: MIT
// A point in neither set is strictly outside of a plane of the first and of one of the second. The pairs of heights over two
// such planes that the points of the box have make a convex polygon, the hull of those of its corners. It reaches into the
// open quarter where both are negative when a corner of it does, or an edge, which joins the pairs of two corners.
#include "union.h"

#include <algorithm>

namespace occlude::oracle {
namespace {

/// Whether both heights are negative at a point on the segment between two corners, at one of which `f` is negative, at the
/// other `g`. From the first to the second, f reaches zero at the part f_first / (f_first - f_second) of the way, g falls
/// below zero at the part g_first / (g_first - g_second).
template <class N>
bool are_negative_between(const N& f_first, const N& g_first, const N& f_second, const N& g_second) {
  return certain_sign(f_first * g_second - f_second * g_first) == CGAL::POSITIVE;
}

/// Whether the box has a point with both heights negative.
bool has_point_outside(Plane<OrientedPlane>& p, Plane<OrientedPlane>& q, const Box& box) {
  return decide([&]<class N>() {
    const OfCorners<N> f = corner_heights(p.in<N>(), box), g = corner_heights(q.in<N>(), box);
    const auto is_negative = [](const N& height) { return certain_sign(height) == CGAL::NEGATIVE; };
    for (unsigned a = 0; a < kCorners; ++a) {
      if (!is_negative(f[a])) continue;
      if (is_negative(g[a])) return true;
      for (unsigned b = 0; b < kCorners; ++b) {
        if (is_negative(g[b]) && are_negative_between(f[a], g[a], f[b], g[b])) return true;
      }
    }
    return false;
  });
}

}  // namespace

bool cover(const Planes& first, const Planes& second, const Box& box) {
  return std::ranges::none_of(first, [&](Plane<OrientedPlane>* p) {
    return std::ranges::any_of(second, [&](Plane<OrientedPlane>* q) { return has_point_outside(*p, *q, box); });
  });
}

}  // namespace occlude::oracle
