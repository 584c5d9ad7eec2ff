// SPDX-License-Identifier: MIT
#include "box_plane.h"

#include <cstddef>

namespace occlude::kernel {
namespace {

/// Where the box lies to one plane, as far as the filter can tell. Uncertain `not_outer`: inner or straddling.
enum class Side { outer, straddling, inner, not_outer, unknown };

Side filter_side(const FilterPlane& plane, const Aabb& box) {
  const ExtremalValues<PlainArithmetic> values(plane, box);
  double reach = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double origin = plane.origin[axis];
    reach = std::max({reach, std::fabs(box.min[axis] - origin), std::fabs(box.max[axis] - origin)});
  }
  const double error = plane.bound * reach;
  if (values.high < -error) return Side::outer;
  if (values.low > error) return Side::inner;
  if (values.high > error) return values.low < -error ? Side::straddling : Side::not_outer;
  return Side::unknown;
}

/// The exact sign of the plane at the extremal vertex of the box, nearest (`direction` = -1) or farthest (1) along its
/// normal.
template <class A>
int extremal_sign(A& arithmetic, const ExactPlane& plane, const Aabb& box, int direction) {
  const auto n = normal<A>(plane);
  const auto positive = [&](int axis) { return direction * arithmetic.sign(n[axis]) >= 0; };
  const Vec3 vertex = extremal_vertex(box, positive(0), positive(1), positive(2));
  return arithmetic.sign(dot(n, difference<A>(vertex, plane.origin)));
}

Side exact_side(const ExactPlane& plane, const Aabb& box, bool touching_is_inner, Stage& stage) {
  const auto sign = [&](int direction) {
    return certified([&](auto& arithmetic) { return extremal_sign(arithmetic, plane, box, direction); }, &stage);
  };
  if (sign(1) < 0) return Side::outer;
  return sign(-1) >= (touching_is_inner ? 0 : 1) ? Side::inner : Side::straddling;
}

}  // namespace

Decision box_planes_certified(const ShadowFrustum& frustum, const Aabb& box, NearBoundary near) {
  const auto filter_planes = frustum.filter_planes();
  bool straddling = false, unknown = false, open = false;
  for (const FilterPlane& plane : filter_planes) {
    const Side side = filter_side(plane, box);
    if (side == Side::outer) return {Relation::outside, Stage::filter};
    straddling = straddling || side == Side::straddling;
    unknown = unknown || side == Side::unknown;
    open = open || side == Side::not_outer;
  }
  if (straddling && !unknown) return {Relation::partial, Stage::filter};
  if (!unknown && !open) return {Relation::inside, Stage::filter};

  Decision decision{straddling ? Relation::partial : Relation::inside, Stage::filter};
  for (std::size_t i = 0; i < filter_planes.size(); ++i) {
    const Side rough = filter_side(filter_planes[i], box);
    if (rough != Side::unknown && rough != Side::not_outer) continue;
    const bool is_near = i == 0;
    const bool touching_is_inner = !(is_near && near == NearBoundary::open);
    const Side side = exact_side(frustum.exact_planes()[i], box, touching_is_inner, decision.stage);
    if (side == Side::outer) return {Relation::outside, decision.stage};
    if (side == Side::straddling) decision.relation = Relation::partial;
  }
  return decision;
}

}  // namespace occlude::kernel
