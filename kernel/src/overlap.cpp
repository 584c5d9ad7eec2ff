// SPDX-License-Identifier: MIT
#include "occlude/kernel/overlap.h"

#include "certified_overlap.h"

namespace occlude::kernel {
namespace {

template <class Box>
Decision decide_on(const ShadowFrustum& frustum, const Box& box, Arithmetic arithmetic, Test test, NearBoundary near) {
  if (arithmetic == Arithmetic::plain) {
    return {test == Test::overlap ? overlap_plain(frustum, box, near) : conservative_plain(frustum, box, near),
            Stage::filter};
  }
  return test == Test::overlap ? overlap_certified(frustum, box, near) : conservative_certified(frustum, box, near);
}

}  // namespace

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

}  // namespace occlude::kernel
