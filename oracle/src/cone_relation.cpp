// SPDX-License-Identifier: MIT
// The cones are the intersections of their sides' half-spaces. They share a ray when they have a common point that is not
// the eye. If there is any, one of the occludee is among them, and that lies in the box about the occludee and not before a
// plane that has the whole occludee beyond it, the eye before it.
#include <algorithm>

#include "loop.h"
#include "occlude/oracle/questions.h"
#include "occludee.h"
#include "prepared.h"
#include "silhouette.h"

namespace occlude::oracle {
namespace {

/// A plane that has the eye strictly before it and no vertex of the polygon: it is parallel to the mean plane of the
/// polygon, which has all of it ahead of the eye (loop.cpp).
OrientedPlane front_of(const Viewpoint& view, const Loop& loop) {
  const CGAL::Sign turn = see(view, loop).turn;
  const auto is_nearest = [&](const Point& v) {
    Plane plane(MeanPlane{loop, v});
    return std::ranges::all_of(loop, [&](const Point& u) { return plane.side(u) != -turn; });
  };
  return {MeanPlane{loop, *std::ranges::find_if(loop, is_nearest)}, turn};
}

/// The same of a polytope: the plane of a face turned to the viewpoint.
OrientedPlane front_of(const Viewpoint& view, const Polytope& polytope) {
  const Solid solid = solid_of(polytope).solid;
  const std::vector<bool> is_turned = turned_faces(view, solid);
  return solid.half_space(static_cast<std::size_t>(std::ranges::find(is_turned, true) - is_turned.begin()));
}

}  // namespace

Answer cone_relation(const Viewpoint& view, const Occluder& occluder, const Occluder& occludee) {
  const RoundUpward rounding;
  Prepared outer(view, occluder, {}), inner(view, occludee, {});
  for (const Prepared* prepared : {&outer, &inner}) {
    if (!prepared->fault().empty()) return {prepared->fault(), Relation::partial};
  }
  const std::vector<Point>& vertices = vertices_of(occludee);
  const auto is_within = [&](Plane<OrientedPlane>& side) {
    return std::ranges::all_of(vertices, [&](const Point& v) { return side.side(v) != CGAL::NEGATIVE; });
  };
  if (std::ranges::all_of(outer.frustum.sides, is_within)) return {"", Relation::inside};
  Plane front(std::visit([&](const auto& kind) { return front_of(view, kind); }, occludee));
  Planes planes{&front};
  append(planes, outer.frustum.sides);
  append(planes, inner.frustum.sides);
  return {"", share_a_point(planes, bounding_box(vertices)) ? Relation::partial : Relation::outside};
}

}  // namespace occlude::oracle
