// SPDX-License-Identifier: MIT
#include "plain_overlap.h"

#include "arithmetic.h"

namespace occlude::kernel {

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

}  // namespace occlude::kernel
