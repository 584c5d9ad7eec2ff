// SPDX-License-Identifier: MIT
#include "near_side.h"

#include <algorithm>

namespace occlude::oracle::second {
namespace {

bool is_farther(const Viewpoint& view, const Point& a, const Point& b) {
  if (view.at_infinity) return CGAL::angle(from_origin(view.value), exact(a) - exact(b)) == CGAL::ACUTE;
  return CGAL::compare_distance_to_point(exact(view.value), exact(a), exact(b)) == CGAL::LARGER;
}

/// The silhouette vertex farthest from the viewpoint; on a tie the first. For a polytope this is the farthest vertex that
/// the polytope does not hide. Such a vertex v is on a face turned to the viewpoint. Suppose v is not on the border of the
/// union of these faces. Then v lies on or in front of a point of the hull of that border, and some vertex of the border is
/// at least as far as v (farther, for an eye).
Point farthest(const Viewpoint& view, const Occluder& occluder, const Triangles& triangles) {
  std::vector<Point> vertices = vertices_of(occluder);
  std::ranges::stable_sort(vertices, [&](const Point& a, const Point& b) { return is_farther(view, a, b); });
  if (std::holds_alternative<Loop>(occluder)) return vertices.front();
  return *std::ranges::find_if(vertices, [&](const Point& v) { return !triangles.hide(exact(v)); });
}

}  // namespace

std::optional<NearSide> near_side(const Viewpoint& view, const Occluder& occluder, const Near& near,
                                  const Triangles& triangles) {
  constexpr Point kZero{};
  if (near.kind == Near::Kind::surface) return std::nullopt;
  if (near.kind == Near::Kind::plane) return NearSide{kZero, near.normal, near.point};
  const Point p = farthest(view, occluder, triangles);
  return view.at_infinity ? NearSide{kZero, view.value, p} : NearSide{view.value, p, p};
}

bool is_beyond(const NearSide& near, const ExactPoint& x) {
  return CGAL::angle(exact(near.to) - exact(near.from), x - exact(near.point)) != CGAL::OBTUSE;
}

}  // namespace occlude::oracle::second
