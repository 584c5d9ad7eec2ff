// SPDX-License-Identifier: MIT
// Each cone is the intersection of the half-spaces of its sides. The cones share a ray when they share a point that is not
// the eye. Then that ray meets the occludee, and the cones share a point of the occludee. Such a point lies in the bounding
// box of the occludee, and it is not in front of a plane that separates the eye from the occludee. So linear programming
// looks for a common point in that box and beyond that plane, where the eye is not.
#include <algorithm>

#include "loop.h"
#include "occlude/oracle/questions.h"
#include "occludee.h"
#include "prepared.h"
#include "silhouette.h"

namespace occlude::oracle {
namespace {

/// A plane with the eye strictly in front of it and no vertex of the polygon in front of it. It is parallel to the mean
/// plane of the polygon and passes through the nearest vertex in that direction. The eye is in front of it because every
/// vertex lies ahead of the eye in that direction (lies_ahead() in loop.cpp).
OrientedPlane front_of(const Viewpoint& view, const Loop& loop) {
  const CGAL::Sign turn = see(view, loop).turn;
  const auto is_nearest = [&](const Point& v) {
    Plane plane(MeanPlane{loop, v});
    return std::ranges::all_of(loop, [&](const Point& u) { return plane.side(u) != -turn; });
  };
  return {MeanPlane{loop, *std::ranges::find_if(loop, is_nearest)}, turn};
}

/// The same for a polytope: the plane of a face turned to the viewpoint.
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
