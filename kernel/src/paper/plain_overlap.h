// SPDX-License-Identifier: MIT
// The paper's overlap test (section 5.3) in any arithmetic.
//
// The planes come first because they decide most boxes. They alone decide `inside`, and a box that one of them separates
// from the frustum is `outside`. A box that no plane decides meets the frustum exactly when an edge of the box meets the
// frustum (stage 3) or an edge of the frustum meets the box (stage 2): the frustum is unbounded, so it cannot lie within the
// box.
#pragma once

#include "corner_frame.h"
#include "edge_frustum.h"
#include "edge_slab.h"
#include "occlude/kernel/overlap.h"

namespace occlude::kernel {

/// Stage 1: the box against each plane by its two extremal vertices.
template <class Frame>
[[nodiscard]] Relation box_planes_plain(const StoredFrustum& frustum, const Frame& frame, NearBoundary near) {
  const auto planes = frustum.own_planes();
  bool inside = true;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const auto extremes = frame.extremes(planes[i]);
    if (extremes.high() < 0) return Relation::outside;
    const double low = extremes.low();
    const bool must_be_beyond = near == NearBoundary::open && i < frustum.near_count;
    inside = inside && (must_be_beyond ? low > 0 : low >= 0);
  }
  return inside ? Relation::inside : Relation::partial;
}

template <class A, class Box>
[[nodiscard]] Relation plain_conservative(const ShadowFrustum& shadow, const Box& box, NearBoundary near) {
  const StoredFrustum* const frustum = stored(shadow);
  return frustum ? box_planes_plain(*frustum, plain_frame_of<A>(box, frustum->origin), near) : Relation::partial;
}

template <class A, class Box>
[[nodiscard]] Relation plain_overlap(const ShadowFrustum& shadow, const Box& box, NearBoundary near) {
  const StoredFrustum* const frustum = stored(shadow);
  if (!frustum) return Relation::partial;
  const Relation by_planes = box_planes_plain(*frustum, plain_frame_of<A>(box, frustum->origin), near);
  if (by_planes != Relation::partial) return by_planes;
  return edge_frustum<A>(*frustum, box) || edge_slab<A>(*frustum, box) ? Relation::partial : Relation::outside;
}

}  // namespace occlude::kernel
