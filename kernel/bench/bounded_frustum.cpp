// SPDX-License-Identifier: MIT
#include "bounded_frustum.h"

#include <algorithm>

#include "vector_math.h"

namespace occlude::bench {
namespace {

/// The reach of the farthest box from the eye, as a multiple of the distance of the near plane.
double farthest(const Workload& workload) {
  const Vec3 eye = workload.frustum.viewpoint().value;
  const kernel::HalfSpace near = workload.frustum.rounded_plane(0);
  const double near_distance = -near.offset;
  double reach = 1;
  for (const kernel::Aabb& box : workload.boxes) {
    for (unsigned i = 0; i < 8; ++i) reach = std::max(reach, dot(near.normal, corner(box, i) - eye) / near_distance);
  }
  return reach;
}

}  // namespace

BoundedFrustum::BoundedFrustum(const Workload& workload) {
  const Vec3 eye = workload.frustum.viewpoint().value;
  const double far = 2 * farthest(workload);
  for (std::size_t i = 0; i < 4; ++i) {
    corners[i] = workload.frustum.silhouette()[i];
    corners[i + 4] = eye + far * (corners[i] - eye);
  }
  Vec3 sum;
  for (const Vec3& c : corners) sum = sum + c;
  center = 0.125 * sum;
}

}  // namespace occlude::bench
