// SPDX-License-Identifier: MIT
#include "relate.h"

namespace occlude::oracle {
namespace {

/// Bit c is set when corner c of the box is strictly outside the plane.
unsigned outer_corners(Plane<OrientedPlane>& plane, const Box& box) {
  const OfCorners<CGAL::Sign> sides = corner_sides(plane, box);
  unsigned outer = 0;
  for (unsigned c = 0; c < kCorners; ++c) {
    if (sides[c] == CGAL::NEGATIVE) outer |= 1U << c;
  }
  return outer;
}

}  // namespace

bool share_a_point(const Planes& planes, const Box& box) {
  return decide([&]<class N>() {
    std::vector<Inequality<N, 3>> inequalities;
    for (Plane<OrientedPlane>* plane : planes) inequalities.push_back(in_own_coordinates(plane->in<N>(), box));
    return is_feasible<N>(own_bounds<N>(box), std::move(inequalities));
  });
}

Relation relate(const Planes& planes, const Box& box) {
  constexpr unsigned kAllCorners = (1U << kCorners) - 1;
  Planes crossing;  // those with a corner of the box outside
  unsigned outer_of_any = 0;
  for (Plane<OrientedPlane>* plane : planes) {
    const unsigned outer = outer_corners(*plane, box);
    if (outer == kAllCorners) return Relation::outside;
    if (outer != 0) crossing.push_back(plane);
    outer_of_any |= outer;
  }
  if (crossing.empty()) return Relation::inside;
  if (outer_of_any != kAllCorners) return Relation::partial;  // some corner is on all inner sides
  return share_a_point(crossing, box) ? Relation::partial : Relation::outside;
}

}  // namespace occlude::oracle
