// SPDX-License-Identifier: MIT
// Stage 2 of the paper's overlap test (section 5.3): each edge of the frustum is clipped by the three slabs of the box.
#pragma once

#include <array>
#include <cstddef>

#include "frustum_edges.h"
#include "segment_clip.h"

namespace occlude::kernel {

/// The slabs of an axis-aligned box: the bounds of its coordinates, relative to the origin of the frustum.
template <class A>
class AabbSlabs {
 public:
  using Vector = Vector3<typename A::Number>;
  AabbSlabs(const Aabb& box, const Vec3& origin)
      : low_(difference<A>(box.min, origin)), high_(difference<A>(box.max, origin)) {}

  /// The values of the six faces at a point, >= 0 inside: the lower faces, then the upper ones.
  [[nodiscard]] std::array<Vector, 2> at_point(const Vec3& p) const {
    return {constants<A>(p) - low_, high_ - constants<A>(p)};
  }
  /// The same for a point at infinity.
  [[nodiscard]] std::array<Vector, 2> at_direction(const Vec3& d) const {
    return {constants<A>(d), constants<A>({}) - constants<A>(d)};
  }

 private:
  Vector low_, high_;
};

/// The slabs of an oriented box. Their normals are cross products of its edges. An edge that is zero is replaced by a
/// direction across the others, so that flat boxes and needles are bounded too.
template <class A>
class ObbSlabs {
 public:
  using Vector = Vector3<typename A::Number>;
  ObbSlabs(const Obb& box, const Vec3& origin) : center_(difference<A>(box.center, origin)) {
    std::array<Vector, 3> edges;
    for (std::size_t k = 0; k < 3; ++k) edges[k] = constants<A>(box.half_edges[k]);
    complete(edges);
    std::array<Vector, 3> normals;
    for (std::size_t k = 0; k < 3; ++k) normals[k] = cross(edges[(k + 1) % 3], edges[(k + 2) % 3]);
    normals_ = normals;
    half_widths_ = {half_width(box, 0), half_width(box, 1), half_width(box, 2)};
  }

  [[nodiscard]] std::array<Vector, 2> at_point(const Vec3& p) const {
    const Vector along = project(constants<A>(p) - center_);
    return {along + half_widths_, half_widths_ - along};
  }
  [[nodiscard]] std::array<Vector, 2> at_direction(const Vec3& d) const {
    const Vector along = project(constants<A>(d));
    return {along, constants<A>({}) - along};
  }

 private:
  static bool is_zero(const Vector& v) { return A::sign(v.x) == 0 && A::sign(v.y) == 0 && A::sign(v.z) == 0; }

  static void complete(std::array<Vector, 3>& edges) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!is_zero(edges[k])) continue;
      edges[k] = cross(edges[(k + 1) % 3], edges[(k + 2) % 3]);
      for (int axis = 0; axis < 3 && is_zero(edges[k]); ++axis) {
        Vec3 unit;
        unit[axis] = 1;
        const Vector& other = is_zero(edges[(k + 1) % 3]) ? edges[(k + 2) % 3] : edges[(k + 1) % 3];
        edges[k] = is_zero(other) ? constants<A>(unit) : cross(other, constants<A>(unit));
      }
    }
  }

  [[nodiscard]] typename A::Number half_width(const Obb& box, std::size_t k) const {
    return A::magnitude(dot(normals_[k], constants<A>(box.half_edges[k])));
  }
  [[nodiscard]] Vector project(const Vector& v) const {
    return {dot(normals_[0], v), dot(normals_[1], v), dot(normals_[2], v)};
  }

  Vector center_, half_widths_;
  std::array<Vector, 3> normals_;
};

template <class A>
[[nodiscard]] AabbSlabs<A> slabs_of(const Aabb& box, const Vec3& origin) {
  return {box, origin};
}
template <class A>
[[nodiscard]] ObbSlabs<A> slabs_of(const Obb& box, const Vec3& origin) {
  return {box, origin};
}

/// Whether an edge of the frustum shares a point with the box.
template <class A, class Box>
[[nodiscard]] bool edge_slab(const StoredFrustum& frustum, const Box& box) {
  const auto slabs = slabs_of<A>(box, frustum.origin);
  A arithmetic;
  return visit_edges(frustum, [&](const FrustumEdge& edge) {
    const auto from = slabs.at_point(edge.from), to = edge.is_ray ? slabs.at_direction(edge.to) : slabs.at_point(edge.to);
    SegmentClip<A> left(arithmetic);
    for (std::size_t face = 0; face < 2; ++face) {
      for (int axis = 0; axis < 3; ++axis) left.clip(from[face][axis], to[face][axis]);
    }
    return !left.empty();
  });
}

}  // namespace occlude::kernel
