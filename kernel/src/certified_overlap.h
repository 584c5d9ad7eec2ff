// SPDX-License-Identifier: MIT
// The certified overlap test. The planes of the frustum come first because they decide most boxes (section 5.3). They alone
// decide `inside`, and a box that one of them separates from the frustum is `outside`. The planes of the profile decide the
// rest. `A` is the arithmetic of the filter: PlainArithmetic or CountingArithmetic.
#pragma once

#include "box_plane.h"
#include "profile.h"

namespace occlude::kernel {

/// Whether a plane of the frustum's profile along these axes separates the frustum from the box: the planes are made for
/// this question alone.
template <class Box>
[[nodiscard]] bool is_separated_along(const BoxAxes& axes, const StoredFrustum& frustum, const Box& box, Stage& stage) {
  const auto sign_along = [&](std::size_t plane, std::size_t k) {
    const auto question = [&]<class A>(A& arithmetic) {
      return arithmetic.sign(dot(normal<A>(plane_of(frustum, plane)), constants<A>(axes.directions[k])));
    };
    return certified(question, &stage);
  };
  const auto separates = [&](const PlaneRecipe& recipe) {
    const auto question = [&]<class A>(A& arithmetic) {
      return extremal_sign(arithmetic, coefficients<A>(frustum, recipe), frustum.origin, box, 1) < 0;
    };
    return certified(question, &stage);
  };
  return visit_profile(frustum, axes, sign_along, separates);
}

/// The same along the coordinate axes, by the planes that the frustum stores.
template <class Frame>
[[nodiscard]] bool is_separated_by_stored(const StoredFrustum& frustum, const Aabb& box, const Frame& frame, Stage& stage) {
  const auto& planes = frustum.filter_planes;
  const double error = frame.error(frustum.profile_bound);
  bool unknown = false;
  for (std::size_t i = frustum.plane_count; i < planes.size(); ++i) {
    const double high = frame.extremes(planes[i]).high();
    if (high < -error) return true;
    unknown = unknown || high <= error;
  }
  if (!unknown) return false;
  stage = Stage::exact;
  for (std::size_t i = frustum.plane_count; i < planes.size(); ++i) {
    if (frame.extremes(planes[i]).high() > error) continue;
    if (exact_extremal_sign(frustum, i, box, frame.reach(), 1) < 0) return true;
  }
  return false;
}

/// The same along the edges of the box.
template <class Frame>
[[nodiscard]] bool is_separated_by_profile(const StoredFrustum& frustum, const Aabb& box, const Frame& frame, Stage& stage) {
  return frustum.has_profile ? is_separated_by_stored(frustum, box, frame, stage)
                             : is_separated_along(BoxAxes{}, frustum, box, stage);
}
template <class Frame>
[[nodiscard]] bool is_separated_by_profile(const StoredFrustum& frustum, const Obb& box, const Frame&, Stage& stage) {
  return is_separated_along({box.half_edges, false}, frustum, box, stage);
}

/// The answer for a frustum that was never made.
inline constexpr Decision kNotKnown{Relation::partial, Stage::filter};

template <class A, class Box>
[[nodiscard]] Decision certified_overlap(const ShadowFrustum& shadow, const Box& box, NearBoundary near) {
  const StoredFrustum* const frustum = stored(shadow);
  if (!frustum) [[unlikely]]
    return kNotKnown;
  const auto frame = frame_of<A>(box, frustum->origin);
  Decision decision = box_planes_certified(*frustum, box, frame, near);
  if (decision.relation == Relation::partial && is_separated_by_profile(*frustum, box, frame, decision.stage)) {
    decision.relation = Relation::outside;
  }
  return decision;
}

template <class A, class Box>
[[nodiscard]] Decision certified_conservative(const ShadowFrustum& shadow, const Box& box, NearBoundary near) {
  const StoredFrustum* const frustum = stored(shadow);
  if (!frustum) [[unlikely]]
    return kNotKnown;
  return box_planes_certified(*frustum, box, frame_of<A>(box, frustum->origin), near);
}

}  // namespace occlude::kernel
