// SPDX-License-Identifier: MIT
// A box lies in the union of two convex sets exactly when, for every plane of the first, the part of the box that the plane
// cuts off lies in the second. It is enough to test the corners of this part: the corners of the box beyond the plane, and
// the points where the plane crosses edges of the box.
#include "occlude/kernel/shadow_union.h"

#include <array>
#include <cstddef>

#include "plane_coefficients.h"

namespace occlude::kernel {
namespace {

/// Corner i is on the upper side of axis k where bit k of i is set.
Vec3 corner_of(const Aabb& box, std::size_t i) {
  return {i & 1U ? box.max.x : box.min.x, i & 2U ? box.max.y : box.min.y, i & 4U ? box.max.z : box.min.z};
}

/// The same corner relative to `origin`, with as few roundings as possible. BoxEdges (paper/edge_frustum.h) adds edges
/// instead, because the paper counts these operations.
template <class A>
Vector3<typename A::Number> corner(const Aabb& box, std::size_t i, const Vec3& origin) {
  return difference<A>(corner_of(box, i), origin);
}
template <class A>
Vector3<typename A::Number> corner(const Obb& box, std::size_t i, const Vec3& origin) {
  auto at = difference<A>(box.center, origin);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto half_edge = constants<A>(box.half_edges[k]);
    at = i >> k & 1U ? at + half_edge : at - half_edge;
  }
  return at;
}

template <class A>
using CornerValues = std::array<typename A::Number, 8>;

template <class A, class Box>
CornerValues<A> values_at_corners(const StoredFrustum& frustum, std::size_t plane, const Box& box) {
  const auto f = coefficients<A>(frustum, frustum.recipes[plane]);
  CornerValues<A> values;
  for (std::size_t i = 0; i < 8; ++i) values[i] = dot(f.normal, corner<A>(box, i, frustum.origin)) + f.offset;
  return values;
}

/// Whether another plane, with values `f`, has at least the sign `least` on the part of the box on the outer side of the
/// plane with values `cut`.
template <class A>
bool is_inner(A& arithmetic, const CornerValues<A>& cut, const CornerValues<A>& f, int least) {
  for (std::size_t i = 0; i < 8; ++i) {
    if (arithmetic.sign(cut[i]) <= 0 && arithmetic.sign(f[i]) < least) return false;
    for (std::size_t axis = 1; axis < 8; axis *= 2) {
      const std::size_t j = i ^ axis;
      // The plane crosses the edge at the mean of its ends i and j, weighted with cut[j] and -cut[i].
      if (arithmetic.sign(cut[i]) < 0 && arithmetic.sign(cut[j]) > 0 &&
          arithmetic.sign(cut[j] * f[i] - cut[i] * f[j]) < least) {
        return false;
      }
    }
  }
  return true;
}

template <class A>
bool is_cut_off_by(A& arithmetic, const CornerValues<A>& values, int least_inner) {
  for (const auto& value : values) {
    if (arithmetic.sign(value) < least_inner) return true;
  }
  return false;
}

/// REQUIRES: neither shadow is none.
template <class Box>
bool is_covered(const ShadowUnion& shadows, const Box& box, NearBoundary near, Stage& stage) {
  // No structured binding: clang 14 captures none.
  const StoredFrustum &first = *stored(shadows.first), &second = *stored(shadows.second);
  const auto least = [&](const StoredFrustum& frustum, std::size_t plane) {
    return near == NearBoundary::open && plane < frustum.near_count ? 1 : 0;
  };
  const auto question = [&]<class A>(A& arithmetic) {
    for (std::size_t i = 0; i < first.plane_count; ++i) {
      const auto cut = values_at_corners<A>(first, i, box);
      if (!is_cut_off_by(arithmetic, cut, least(first, i))) continue;
      for (std::size_t j = 0; j < second.plane_count; ++j) {
        if (!is_inner(arithmetic, cut, values_at_corners<A>(second, j, box), least(second, j))) return false;
      }
    }
    return true;
  };
  return certified(question, &stage);
}

/// Whether some corner is in neither shadow, which is so for most boxes that are not in the union. This is cheaper than
/// is_covered(): it asks the planes that the frusta store, and is_covered() computes them anew.
bool has_corner_outside(const ShadowUnion& shadows, const Aabb& box, NearBoundary near) {
  for (std::size_t i = 0; i < 8; ++i) {
    const Vec3 x = corner_of(box, i);
    const auto is_outside = [&](const ShadowFrustum& frustum) {
      return conservative_certified(frustum, Aabb{x, x}, near).relation == Relation::outside;
    };
    if (is_outside(shadows.first) && is_outside(shadows.second)) return true;
  }
  return false;
}
/// The corners of oriented boxes need not be doubles, so they are not tested.
bool has_corner_outside(const ShadowUnion&, const Obb&, NearBoundary) { return false; }

template <class Box>
Decision union_overlap(const ShadowUnion& shadows, const Box& box, NearBoundary near) {
  const Decision first = overlap_certified(shadows.first, box, near);
  if (first.relation == Relation::inside) return first;
  const Decision second = overlap_certified(shadows.second, box, near);
  if (second.relation == Relation::inside) return second;
  Decision decision{Relation::partial, first.stage == Stage::exact ? first.stage : second.stage};
  if (first.relation == Relation::outside && second.relation == Relation::outside) {
    decision.relation = Relation::outside;
  } else if (first.relation == Relation::partial && second.relation == Relation::partial && !shadows.first.is_none() &&
             !shadows.second.is_none() && !has_corner_outside(shadows, box, near) &&
             is_covered(shadows, box, near, decision.stage)) {
    decision.relation = Relation::inside;
  }
  return decision;
}

}  // namespace

Decision overlap_certified(const ShadowUnion& shadows, const Aabb& box, NearBoundary near) {
  return union_overlap(shadows, box, near);
}
Decision overlap_certified(const ShadowUnion& shadows, const Obb& box, NearBoundary near) {
  return union_overlap(shadows, box, near);
}

}  // namespace occlude::kernel
