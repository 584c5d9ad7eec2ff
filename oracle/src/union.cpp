// SPDX-License-Identifier: MIT
// A point that is in neither set is outside a plane p of the first and outside a plane q of the second. For each such pair
// of planes, map a point of the box to its two heights over p and q. The box becomes a convex polygon, the hull of the
// images of its corners. This polygon reaches into the quadrant outside both planes when one of its corners does, or one of
// its edges. An edge joins the images of two corners.
#include "union.h"

#include <algorithm>

namespace occlude::oracle {
namespace {

struct BoundingPlane {
  Plane<OrientedPlane>* plane;
  bool is_open;

  template <class N>
  [[nodiscard]] bool has_outside(const N& height) const {
    const CGAL::Sign sign = certain_sign(height);
    return sign == CGAL::NEGATIVE || (is_open && sign == CGAL::ZERO);
  }
};

std::vector<BoundingPlane> bounds_of(const ConvexSet& set) {
  std::vector<BoundingPlane> bounds;
  for (Plane<OrientedPlane>* plane : set.closed) bounds.push_back({plane, false});
  for (Plane<OrientedPlane>* plane : set.open) bounds.push_back({plane, true});
  return bounds;
}

/// Whether the box has a point outside both planes. Let f be the height over p and g the height over q. Take a corner
/// `first` with f outside and a corner `second` with g outside, neither of which is outside both. From first to second, f
/// rises and reaches zero at the fraction f_first / (f_first - f_second). g falls and reaches zero at the fraction g_first /
/// (g_first - g_second). Points of the segment are outside both when g reaches zero first. When both reach zero together,
/// that point is outside both only if both planes are open.
bool has_point_outside(const BoundingPlane& p, const BoundingPlane& q, const Box& box) {
  return decide([&]<class N>() {
    const OfCorners<N> f = corner_heights(p.plane->in<N>(), box), g = corner_heights(q.plane->in<N>(), box);
    const auto is_outside_between = [&](unsigned first, unsigned second) {
      const CGAL::Sign order = certain_sign(f[first] * g[second] - f[second] * g[first]);
      return order == CGAL::POSITIVE || (order == CGAL::ZERO && p.is_open && q.is_open);
    };
    for (unsigned a = 0; a < kCorners; ++a) {
      if (!p.has_outside(f[a])) continue;
      if (q.has_outside(g[a])) return true;
      for (unsigned b = 0; b < kCorners; ++b) {
        if (q.has_outside(g[b]) && is_outside_between(a, b)) return true;
      }
    }
    return false;
  });
}

}  // namespace

bool cover(const ConvexSet& first, const ConvexSet& second, const Box& box) {
  const std::vector<BoundingPlane> others = bounds_of(second);
  return std::ranges::none_of(bounds_of(first), [&](const BoundingPlane& p) {
    return std::ranges::any_of(others, [&](const BoundingPlane& q) { return has_point_outside(p, q, box); });
  });
}

}  // namespace occlude::oracle
