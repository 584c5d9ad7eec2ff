// SPDX-License-Identifier: MIT
// Stage 3 of the paper's overlap test (section 5.3): the twelve edges of the box, each clipped by all planes of the frustum.
#pragma once

#include <array>
#include <cstddef>

#include "arithmetic.h"
#include "segment_clip.h"
#include "stored_frustum.h"
#include "vector3.h"

namespace occlude::kernel {

/// The corners and edges of a box, relative to the origin of a frustum.
template <class A>
class BoxEdges {
 public:
  using Vector = Vector3<typename A::Number>;
  BoxEdges(const Aabb& box, const Vec3& origin) : first_(difference<A>(box.min, origin)) {
    const auto extent = difference<A>(box.max, box.min);
    const auto zero = A::constant(0);
    edges_ = {Vector{extent.x, zero, zero}, Vector{zero, extent.y, zero}, Vector{zero, zero, extent.z}};
  }
  BoxEdges(const Obb& box, const Vec3& origin) : first_(difference<A>(box.center, origin)) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto half = constants<A>(box.half_edges[k]);
      first_ = first_ - half;
      edges_[k] = half + half;
    }
  }

  /// Corner i is at the end of edge k when bit k of i is set, else at its start.
  [[nodiscard]] Vector corner(std::size_t i) const {
    Vector at = first_;
    for (std::size_t k = 0; k < 3; ++k) {
      if (i >> k & 1U) at = at + edges_[k];
    }
    return at;
  }
  [[nodiscard]] const Vector& edge(std::size_t k) const { return edges_[k]; }

 private:
  Vector first_;
  std::array<Vector, 3> edges_;
};

/// Whether the edge from `start` along `edge` shares a point with the frustum.
template <class A>
[[nodiscard]] bool is_in_frustum(const StoredFrustum& frustum, const Vector3<typename A::Number>& start,
                                 const Vector3<typename A::Number>& edge) {
  A arithmetic;
  SegmentClip<A> left(arithmetic);
  for (std::size_t p = 0; p < frustum.plane_count; ++p) {
    const FilterPlane& plane = frustum.filter_planes[p];
    const auto normal = constants<A>(plane.normal);
    const auto at_start = dot(normal, start) + A::constant(plane.offset);
    left.clip(at_start, at_start + dot(normal, edge));
    if (left.empty()) return false;
  }
  return true;
}

/// Whether an edge of the box shares a point with the frustum.
template <class A, class Box>
[[nodiscard]] bool edge_frustum(const StoredFrustum& frustum, const Box& box) {
  const BoxEdges<A> box_edges(box, frustum.origin);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t corner = 0; corner < 8; ++corner) {
      if (corner >> axis & 1U) continue;
      if (is_in_frustum<A>(frustum, box_edges.corner(corner), box_edges.edge(axis))) return true;
    }
  }
  return false;
}

}  // namespace occlude::kernel
