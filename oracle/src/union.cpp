// SPDX-License-Identifier: MIT
// A point in neither set is outside of a plane of the first and of one of the second. The pairs of heights over two such
// planes that the points of the box have make a convex polygon, the hull of those of its corners. It reaches into the
// quarter where both are outside when a corner of it does, or an edge, which joins the pairs of two corners.
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

/// Whether the box has a point outside of both. Where neither a corner with f outside nor one with g outside has both, f
/// rises from the first to the second and reaches zero at the part f_first / (f_first - f_second) of the way; g falls, and
/// reaches zero at the part g_first / (g_first - g_second). Where these are one, only zero itself can be outside of both.
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
