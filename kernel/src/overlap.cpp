// SPDX-License-Identifier: MIT
// The overlap test as the paper lists it (section 5.3): planes first, for they decide nearly always; then edges.
//
// A box that no plane decides meets the frustum exactly when one of its edges does (stage 3) or, failing that, when an edge
// of the frustum meets the box (stage 2): the frustum is unbounded, so it cannot hide within the box, and if it passes
// through the faces of the box between their edges, what it cuts from such a face has corners on the frustum's edges.
#include "occlude/kernel/overlap.h"

#include "box_plane.h"
#include "counting.h"
#include "edge_frustum.h"
#include "edge_slab.h"

namespace occlude::kernel {
namespace {

template <class A>
Relation edge_stages(A& arithmetic, const ShadowFrustum& frustum, const Aabb& box) {
  const bool meet = edge_frustum(arithmetic, frustum, box) || edge_slab(arithmetic, frustum, box);
  return meet ? Relation::partial : Relation::outside;
}

template <class A>
Relation overlap_uncertified(const ShadowFrustum& frustum, const Aabb& box, NearBoundary near) {
  const Relation by_planes = box_planes_plain<A>(frustum, box, near);
  if (by_planes != Relation::partial) return by_planes;
  A arithmetic;
  return edge_stages(arithmetic, frustum, box);
}

}  // namespace

Relation overlap_plain(const ShadowFrustum& frustum, const Aabb& box, NearBoundary near) {
  return overlap_uncertified<PlainArithmetic>(frustum, box, near);
}

Relation conservative_plain(const ShadowFrustum& frustum, const Aabb& box, NearBoundary near) {
  return box_planes_plain<PlainArithmetic>(frustum, box, near);
}

Decision conservative_certified(const ShadowFrustum& frustum, const Aabb& box, NearBoundary near) {
  return box_planes_certified(frustum, box, near);
}

Decision overlap_certified(const ShadowFrustum& frustum, const Aabb& box, NearBoundary near) {
  Decision decision = box_planes_certified(frustum, box, near);
  if (decision.relation == Relation::partial) {
    decision.relation = certified([&](auto& arithmetic) { return edge_stages(arithmetic, frustum, box); }, &decision.stage);
  }
  return decision;
}

Relation relation(const ShadowFrustum& frustum, const Aabb& box, Arithmetic arithmetic, Test test, NearBoundary near) {
  if (arithmetic == Arithmetic::plain) {
    return test == Test::overlap ? overlap_plain(frustum, box, near) : conservative_plain(frustum, box, near);
  }
  return (test == Test::overlap ? overlap_certified(frustum, box, near) : conservative_certified(frustum, box, near))
      .relation;
}

Operations count_operations(const ShadowFrustum& frustum, const Aabb& box, Test test) {
  operation_counter = {.tests = 1};
  if (test == Test::overlap) {
    static_cast<void>(overlap_uncertified<CountingArithmetic>(frustum, box, NearBoundary::closed));
  } else {
    static_cast<void>(box_planes_plain<CountingArithmetic>(frustum, box, NearBoundary::closed));
  }
  return operation_counter;
}

}  // namespace occlude::kernel
