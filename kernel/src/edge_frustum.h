// SPDX-License-Identifier: MIT
// Stage 3 of the overlap test (section 5.3): the twelve edges of the box, each clipped by all planes of the frustum at once.
// Reading order: 7.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "plane_value.h"
#include "segment_clip.h"

namespace occlude::kernel {

/// Corner i of the box takes the maximum on axis k where bit k of i is set.
[[nodiscard]] inline Vec3 corner(const Aabb& box, std::size_t i) {
  return {i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z};
}

/// Whether an edge of the box shares a point with the frustum.
template <class A>
[[nodiscard]] bool edge_frustum(A& arithmetic, const ShadowFrustum& frustum, const Aabb& box) {
  using Number = typename A::Number;
  std::vector<std::array<Number, 8>> values;  // of each plane at each corner
  values.reserve(frustum.exact_planes().size());
  for (const ExactPlane& plane : frustum.exact_planes()) {
    const auto n = normal<A>(plane);
    auto& row = values.emplace_back();
    for (std::size_t i = 0; i < 8; ++i) row[i] = dot(n, difference<A>(corner(box, i), plane.origin));
  }
  for (std::size_t axis = 1; axis < 8; axis *= 2) {
    for (std::size_t from = 0; from < 8; ++from) {
      if (from & axis) continue;
      SegmentClip<A> edge(arithmetic);
      for (const auto& row : values) edge.clip(row[from], row[from | axis]);
      if (!edge.empty()) return true;
      if (arithmetic.failed()) return false;
    }
  }
  return false;
}

}  // namespace occlude::kernel
