// SPDX-License-Identifier: MIT
// The edges of a shadow frustum in plain doubles, relative to its origin: the rays in which neighbouring side planes meet,
// from the near side outwards, and the edges of the near side. They are computed on demand, because only this test needs
// them.
#pragma once

#include <cstddef>

#include "plane_coefficients.h"

namespace occlude::kernel {

/// An edge from one point to another, or from a point along a direction.
struct FrustumEdge {
  Vec3 from, to;
  bool is_ray = false;  ///< `to` is a direction
};

[[nodiscard]] inline FrustumEdge frustum_edge(const Vector3<double>& from, const Vector3<double>& to, bool is_ray) {
  return {{from.x, from.y, from.z}, {to.x, to.y, to.z}, is_ray};
}

/// The ray of one corner of the silhouette, and the point where the near plane cuts it, if it does.
struct CutRay {
  Vector3<double> direction, start;
  double speed;  ///< change of the near plane's value along the ray; the plane cuts the ray when this is positive
};

[[nodiscard]] inline CutRay cut_ray(const StoredFrustum& frustum, const PlaneCoefficients<PlainArithmetic>& near,
                                    std::size_t corner) {
  const auto d = ray<PlainArithmetic>(frustum, corner);
  const auto s = difference<PlainArithmetic>(frustum.silhouette[corner], frustum.origin);
  const double speed = dot(near.normal, d);
  return {d, s - (dot(near.normal, s) + near.offset) / speed * d, speed};
}

/// The edge of the near side between two rays. Where only one of them reaches the near plane, the near side runs to
/// infinity, parallel to the near plane. REQUIRES: at least one of them reaches it.
[[nodiscard]] inline FrustumEdge near_edge(const CutRay& a, const CutRay& b) {
  if (!(a.speed > 0)) return frustum_edge(b.start, b.speed * a.direction - a.speed * b.direction, true);
  if (!(b.speed > 0)) return frustum_edge(a.start, a.speed * b.direction - b.speed * a.direction, true);
  return frustum_edge(a.start, b.start, false);
}

template <class Visit>
[[nodiscard]] bool visit_cut_edges(const StoredFrustum& frustum, const Visit& visit) {
  const auto near = coefficients<PlainArithmetic>(frustum, plane_of(frustum, 0));
  const std::size_t n = frustum.silhouette.size();
  const CutRay first = cut_ray(frustum, near, 0);
  CutRay a = first;
  for (std::size_t i = 0; i < n; ++i) {
    const CutRay b = i + 1 < n ? cut_ray(frustum, near, i + 1) : first;
    if (a.speed > 0 && visit(frustum_edge(a.start, a.direction, true))) return true;
    if ((a.speed > 0 || b.speed > 0) && visit(near_edge(a, b))) return true;
    a = b;
  }
  return false;
}

template <class Visit>
[[nodiscard]] bool visit_uncut_edges(const StoredFrustum& frustum, const Visit& visit) {
  const auto relative = [&](const Vec3& v) { return difference<PlainArithmetic>(v, frustum.origin); };
  for (std::size_t i = 0; i < frustum.silhouette.size(); ++i) {
    if (visit(frustum_edge(relative(frustum.silhouette[i]), ray<PlainArithmetic>(frustum, i), true))) return true;
  }
  for (const auto& edge : frustum.cap_edges) {
    if (visit(frustum_edge(relative(edge.from), relative(edge.to), false))) return true;
  }
  return false;
}

/// Visits the edges until `visit(edge)` is true; returns whether it was.
template <class Visit>
[[nodiscard]] bool visit_edges(const StoredFrustum& frustum, const Visit& visit) {
  return frustum.is_cut() ? visit_cut_edges(frustum, visit) : visit_uncut_edges(frustum, visit);
}

}  // namespace occlude::kernel
