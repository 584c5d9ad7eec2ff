// SPDX-License-Identifier: MIT
// Stage 2 of the overlap test (section 5.3): each edge of the frustum against the box as three slabs. Reading order: 8.
//
// The edges are the rays in which neighbouring side planes meet, from the near plane outwards, and the border of the near
// face. Their ends are homogeneous points (v, w) = v / w relative to an origin, w = 0 at infinity, so that no near plane,
// however oblique or behind the eye, needs a division or a special case.
#pragma once

#include <cstddef>
#include <vector>

#include "plane_value.h"
#include "segment_clip.h"

namespace occlude::kernel {

template <class Number>
struct HomogeneousPoint {
  Vector3<Number> v;
  Number w;
};

template <class Number>
struct FrustumEdge {
  HomogeneousPoint<Number> from, to;
};

/// The edges of a frustum, and the origin they are relative to: the eye, or a corner of the silhouette for directions.
template <class A>
class FrustumEdges {
 public:
  using Number = typename A::Number;
  using Point = HomogeneousPoint<Number>;

  FrustumEdges(A& arithmetic, const ShadowFrustum& frustum)
      : origin_(frustum.viewpoint().is_eye() ? frustum.viewpoint().value : frustum.silhouette()[0]) {
    if (frustum.viewpoint().is_eye()) {
      build_perspective(arithmetic, frustum);
    } else {
      build_orthographic(frustum);
    }
  }

  [[nodiscard]] const Vec3& origin() const { return origin_; }
  [[nodiscard]] const std::vector<FrustumEdge<Number>>& edges() const { return edges_; }

 private:
  static Number zero() { return A::constant(0); }
  static Number one() { return A::constant(1); }

  /// Along ray i, V + t d_i, the near plane n . (x - r) has the value t a_i - a with a_i = n . d_i and a = n . (r - V): the
  /// shadow begins at t = a / a_i when a_i > 0 and never otherwise. Between a ray that reaches the near plane and one that
  /// does not, the near face runs to infinity along a_i d_j - a_j d_i, which lies in the side plane and parallel to the
  /// near.
  void build_perspective(A& arithmetic, const ShadowFrustum& frustum) {
    const auto corners = frustum.silhouette();
    const ExactPlane& near = frustum.exact_planes()[0];
    const auto n = normal<A>(near);
    const Number a = frustum.near_is_polygon() ? one() : dot(n, difference<A>(near.origin, origin_));
    std::vector<Vector3<Number>> d;
    std::vector<Number> weight;
    std::vector<bool> reaches;
    for (const Vec3& corner : corners) {
      d.push_back(difference<A>(corner, origin_));
      weight.push_back(frustum.near_is_polygon() ? one() : dot(n, d.back()));
      reaches.push_back(arithmetic.sign(weight.back()) > 0);
    }
    const auto start = [&](std::size_t i) { return Point{a * d[i], weight[i]}; };
    for (std::size_t i = 0; i < d.size(); ++i) {
      const std::size_t j = (i + 1) % d.size();
      if (reaches[i]) edges_.push_back({start(i), {d[i], zero()}});
      if (reaches[i] && reaches[j]) {
        edges_.push_back({start(i), start(j)});
      } else if (reaches[i]) {
        edges_.push_back({start(i), {weight[i] * d[j] - weight[j] * d[i], zero()}});
      } else if (reaches[j]) {
        edges_.push_back({start(j), {weight[j] * d[i] - weight[i] * d[j], zero()}});
      }
    }
  }

  /// Along line i, s_i + t d, the near plane has the value n . (s_i - r) + t n . d, and n . d > 0.
  void build_orthographic(const ShadowFrustum& frustum) {
    const auto corners = frustum.silhouette();
    const ExactPlane& near = frustum.exact_planes()[0];
    const auto n = normal<A>(near);
    const auto d = difference<A>(frustum.viewpoint().value, {});
    const auto start = [&](const Vec3& corner) {
      const auto s = difference<A>(corner, origin_);
      if (frustum.near_is_polygon()) return Point{s, one()};
      const Number speed = dot(n, d);
      return Point{speed * s - dot(n, difference<A>(corner, near.origin)) * d, speed};
    };
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point from = start(corners[i]);
      edges_.push_back({from, {d, zero()}});
      edges_.push_back({from, start(corners[(i + 1) % corners.size()])});
    }
  }

  Vec3 origin_;
  std::vector<FrustumEdge<Number>> edges_;
};

/// Whether an edge of the frustum shares a point with the box.
template <class A>
[[nodiscard]] bool edge_slab(A& arithmetic, const ShadowFrustum& frustum, const Aabb& box) {
  const FrustumEdges<A> frustum_edges(arithmetic, frustum);
  const auto low = difference<A>(box.min, frustum_edges.origin());
  const auto high = difference<A>(box.max, frustum_edges.origin());
  for (const auto& [from, to] : frustum_edges.edges()) {
    SegmentClip<A> edge(arithmetic);
    for (int axis = 0; axis < 3; ++axis) {
      edge.clip(from.v[axis] - low[axis] * from.w, to.v[axis] - low[axis] * to.w);
      edge.clip(high[axis] * from.w - from.v[axis], high[axis] * to.w - to.v[axis]);
    }
    if (!edge.empty()) return true;
    if (arithmetic.failed()) return false;
  }
  return false;
}

}  // namespace occlude::kernel
