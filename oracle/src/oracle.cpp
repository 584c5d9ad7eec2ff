// SPDX-License-Identifier: MIT
#include "occlude/oracle/oracle.h"

#include <algorithm>
#include <cmath>

#include "faults.h"
#include "feasibility.h"
#include "frustum.h"

namespace occlude::oracle {
namespace {

using Corners = std::array<Point, 8>;

Corners corners_of(const Box& box) {
  Corners corners;
  for (std::size_t i = 0; i < 8; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) corners[i][axis] = (i >> axis & 1) != 0 ? box.max[axis] : box.min[axis];
  }
  return corners;
}

/// For one plane, bit c set when corner c is strictly outside.
unsigned outer_corners(Plane<PlaneOfFrustum>& plane, const Corners& corners) {
  unsigned outer = 0;
  for (std::size_t c = 0; c < corners.size(); ++c) {
    if (plane.side(corners[c]) == CGAL::NEGATIVE) outer |= 1U << c;
  }
  return outer;
}

Bounds<3> bounds_of(const Box& box) {
  const auto exact = [](const Point& p) { return std::array<Exact, 3>{Exact(p[0]), Exact(p[1]), Exact(p[2])}; };
  return {exact(box.min), exact(box.max)};
}

/// normal . (x - point) >= 0 as a . x <= b.
Inequality<3> inequality_of(const HalfSpace<Exact>& plane) {
  const Vector<Exact>& n = plane.normal;
  return {{Exact(-n.x()), Exact(-n.y()), Exact(-n.z())}, -(n * plane.point)};
}

Relation relate(Frustum& frustum, const Box& box) {
  constexpr unsigned kAllCorners = 0xff;
  const Corners corners = corners_of(box);
  std::vector<Plane<PlaneOfFrustum>*> crossing;  // the planes that some of the box is outside of
  unsigned outer_of_any = 0;
  for (Plane<PlaneOfFrustum>& plane : frustum.planes()) {
    const unsigned outer = outer_corners(plane, corners);
    if (outer == kAllCorners) return Relation::outside;
    if (outer != 0) crossing.push_back(&plane);
    outer_of_any |= outer;
  }
  if (crossing.empty()) return Relation::inside;
  if (outer_of_any != kAllCorners) return Relation::partial;  // some corner is in F
  std::vector<Inequality<3>> inequalities;
  for (auto* plane : crossing) inequalities.push_back(inequality_of(plane->exact()));
  return is_feasible(bounds_of(box), std::move(inequalities)) ? Relation::partial : Relation::outside;
}

/// Everything that makes a case unanswerable, in the order of the tests; the loop's turn when there is nothing.
Seen examine(const Scene& scene, const Box& box) {
  if (std::string fault = number_fault(scene, box); !fault.empty()) return {std::move(fault), CGAL::ZERO};
  Seen seen = see_loop(scene);
  if (seen.fault.empty()) seen.fault = near_fault(scene);
  return seen;
}

}  // namespace

Answer relation(const Viewpoint& view, std::span<const Point> loop, const Near& near, const Box& box) {
  const RoundUpward rounding;
  const Scene scene{view, loop, near};
  const Seen seen = examine(scene, box);
  if (!seen.fault.empty()) return {seen.fault, Relation::partial};
  Frustum frustum(scene, seen.turn);
  return {"", relate(frustum, box)};
}

std::string refute_shadow_cull(const Viewpoint& view, std::span<const Point> loop, const Near& near, const Box& box) {
  const RoundUpward rounding;
  const Scene scene{view, loop, near};
  Seen seen = examine(scene, box);
  if (!seen.fault.empty()) return std::move(seen.fault);
  Frustum frustum(scene, seen.turn);
  const Corners corners = corners_of(box);
  for (Plane<PlaneOfFrustum>& plane : frustum.planes()) {
    if (outer_corners(plane, corners) != 0) return "the box is not inside the frustum";
  }
  const auto is_beyond = [&](const Point& corner) { return frustum.near_plane().side(corner) == CGAL::POSITIVE; };
  return std::ranges::all_of(corners, is_beyond) ? "" : "the box touches the near plane";
}

std::string refute_view_cull(const std::array<double, 4>& plane, const Box& box) {
  const RoundUpward rounding;
  if (!std::ranges::all_of(plane, [](double value) { return std::isfinite(value); })) return "a number is not finite";
  if (std::string fault = box_fault(box); !fault.empty()) return fault;
  const Point normal{plane[0], plane[1], plane[2]};
  for (const Point& corner : corners_of(box)) {
    const auto height = [&]<class N>() { return N(vector_of<N>(normal) * vector_of<N>(corner) + N(plane[3])); };
    if (sign_of(height) != CGAL::NEGATIVE) return "the box reaches the plane";
  }
  return "";
}

}  // namespace occlude::oracle
