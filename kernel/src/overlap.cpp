// SPDX-License-Identifier: MIT
// The overlap test. Planes first, for they decide nearly always (section 5.3): `inside` is all theirs, and a box that one of
// them parts from the frustum is `outside`. For what they leave, `certified` asks the planes of the profile, `plain` the
// edges, as the paper does (plain_overlap.h).
#include "occlude/kernel/overlap.h"

#include "box_plane.h"
#include "counting.h"
#include "plain_overlap.h"
#include "profile.h"

namespace occlude::kernel {
namespace {

/// Whether a plane of the frustum's profile along the coordinate axes parts it from the box.
template <class Frame>
bool is_parted_by_profile(const ShadowFrustum& frustum, const Aabb& box, const Frame& frame, Stage& stage) {
  const auto planes = frustum.filter_planes();
  const double error = frame.error(frustum.profile_bound());
  bool unknown = false;
  for (std::size_t i = frustum.plane_count(); i < planes.size(); ++i) {
    const double high = frame.extremes(planes[i]).high();
    if (high < -error) return true;
    unknown = unknown || high <= error;
  }
  if (!unknown) return false;
  stage = Stage::exact;
  for (std::size_t i = frustum.plane_count(); i < planes.size(); ++i) {
    if (frame.extremes(planes[i]).high() > error) continue;
    if (exact_extremal_sign(frustum, i, box, frame.reach(), 1) < 0) return true;
  }
  return false;
}

/// The same for the profile along the edges of the box.
template <class Frame>
bool is_parted_by_profile(const ShadowFrustum& frustum, const Obb& box, const Frame&, Stage& stage) {
  const auto sign_along = [&](std::size_t plane, std::size_t k) {
    const auto question = [&]<class A>(A& arithmetic) {
      return arithmetic.sign(dot(normal<A>(plane_of(frustum, plane)), constants<A>(box.half_edges[k])));
    };
    return certified(question, &stage);
  };
  const auto parts = [&](const PlaneRecipe& recipe) {
    const auto question = [&]<class A>(A& arithmetic) {
      return extremal_sign(arithmetic, coefficients<A>(frustum, recipe), frustum.origin(), box, 1) < 0;
    };
    return certified(question, &stage);
  };
  return visit_profile(frustum, {box.half_edges, false}, sign_along, parts);
}

/// Of a frustum that was never made.
constexpr Decision kNotKnown{Relation::partial, Stage::filter};

template <class A, class Box>
Decision certified_overlap(const ShadowFrustum& frustum, const Box& box, NearBoundary near) {
  if (frustum.is_none()) [[unlikely]]
    return kNotKnown;
  const auto frame = frame_of<A>(box, frustum.origin());
  Decision decision = box_planes_certified(frustum, box, frame, near);
  if (decision.relation == Relation::partial && is_parted_by_profile(frustum, box, frame, decision.stage)) {
    decision.relation = Relation::outside;
  }
  return decision;
}

template <class A, class Box>
Decision certified_conservative(const ShadowFrustum& frustum, const Box& box, NearBoundary near) {
  if (frustum.is_none()) [[unlikely]]
    return kNotKnown;
  return box_planes_certified(frustum, box, frame_of<A>(box, frustum.origin()), near);
}

template <class Box>
Decision decide_on(const ShadowFrustum& frustum, const Box& box, Arithmetic arithmetic, Test test, NearBoundary near) {
  if (arithmetic == Arithmetic::plain) {
    return {test == Test::overlap ? overlap_plain(frustum, box, near) : conservative_plain(frustum, box, near),
            Stage::filter};
  }
  return test == Test::overlap ? overlap_certified(frustum, box, near) : conservative_certified(frustum, box, near);
}

template <class Box>
Operations count(const ShadowFrustum& frustum, const Box& box, Arithmetic arithmetic, Test test) {
  using A = CountingArithmetic;
  constexpr auto kNear = NearBoundary::closed;
  operation_counter = {.tests = 1};
  if (arithmetic == Arithmetic::plain) {
    static_cast<void>(test == Test::overlap ? plain_overlap<A>(frustum, box, kNear)
                                            : plain_conservative<A>(frustum, box, kNear));
  } else {
    static_cast<void>(test == Test::overlap ? certified_overlap<A>(frustum, box, kNear)
                                            : certified_conservative<A>(frustum, box, kNear));
  }
  return operation_counter;
}

}  // namespace

Relation overlap_plain(const ShadowFrustum& frustum, const Aabb& box, NearBoundary near) {
  return plain_overlap<PlainArithmetic>(frustum, box, near);
}
Relation overlap_plain(const ShadowFrustum& frustum, const Obb& box, NearBoundary near) {
  return plain_overlap<PlainArithmetic>(frustum, box, near);
}

Relation conservative_plain(const ShadowFrustum& frustum, const Aabb& box, NearBoundary near) {
  return plain_conservative<PlainArithmetic>(frustum, box, near);
}
Relation conservative_plain(const ShadowFrustum& frustum, const Obb& box, NearBoundary near) {
  return plain_conservative<PlainArithmetic>(frustum, box, near);
}

Decision overlap_certified(const ShadowFrustum& frustum, const Aabb& box, NearBoundary near) {
  return certified_overlap<PlainArithmetic>(frustum, box, near);
}
Decision overlap_certified(const ShadowFrustum& frustum, const Obb& box, NearBoundary near) {
  return certified_overlap<PlainArithmetic>(frustum, box, near);
}

Decision conservative_certified(const ShadowFrustum& frustum, const Aabb& box, NearBoundary near) {
  return certified_conservative<PlainArithmetic>(frustum, box, near);
}
Decision conservative_certified(const ShadowFrustum& frustum, const Obb& box, NearBoundary near) {
  return certified_conservative<PlainArithmetic>(frustum, box, near);
}

Decision decide(const ShadowFrustum& frustum, const Aabb& box, Arithmetic arithmetic, Test test, NearBoundary near) {
  return decide_on(frustum, box, arithmetic, test, near);
}
Decision decide(const ShadowFrustum& frustum, const Obb& box, Arithmetic arithmetic, Test test, NearBoundary near) {
  return decide_on(frustum, box, arithmetic, test, near);
}

Operations count_operations(const ShadowFrustum& frustum, const Aabb& box, Arithmetic arithmetic, Test test) {
  return count(frustum, box, arithmetic, test);
}
Operations count_operations(const ShadowFrustum& frustum, const Obb& box, Arithmetic arithmetic, Test test) {
  return count(frustum, box, arithmetic, test);
}

}  // namespace occlude::kernel
