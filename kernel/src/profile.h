// SPDX-License-Identifier: MIT
// The profile of a shadow frustum along three axes: the planes, beside the frustum's own, that can separate it from a box
// whose edges are parallel to the axes. Reading order: 8.
//
// Two convex polyhedra are disjoint exactly when a face of their Minkowski difference has the origin on its outer side. For
// a frustum and a box these faces are of three kinds: those of the frustum (stage 1), those spanned by an edge of the
// frustum and an edge of the box, and those of the box. The second kind: seen along an axis, the frustum has an outline. It
// consists of the edges between two planes of which one falls along the axis and one rises. The plane through such an edge
// and parallel to the axis bounds the frustum. The third kind: planes parallel to a face of the box through the frustum's
// extreme vertex, where it has one. For boxes along the coordinate axes this is the test of a box against the frustum's
// outlines in the three projections (Greene 1994, "Detecting intersection of a rectangular solid and a convex polyhedron").
// The test needs only signs of planes: there are no clip parameters and no divisions.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "plane_coefficients.h"

namespace occlude::kernel {

/// Directions of the edges of a box: the coordinate axes, or any three vectors, which may be zero or linearly dependent.
struct BoxAxes {
  std::array<Vec3, 3> directions{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  bool are_coordinate_axes = true;
};

/// The plane through `origin` parallel to the faces of the box across axis k; its inner side is in the direction of axis k
/// times `sign`.
[[nodiscard]] inline ExactPlane face_plane(const BoxAxes& axes, std::size_t k, int sign, const Vec3& origin) {
  const Vec3 &a = axes.directions[(k + 1) % 3], &b = axes.directions[(k + 2) % 3], &c = axes.directions[k];
  if (axes.are_coordinate_axes) {
    return {.direct = true,
            .a_to = sign > 0 ? c : Vec3{},
            .a_from = sign > 0 ? Vec3{} : c,
            .b_to = {},
            .b_from = {},
            .origin = origin};
  }
  return {.direct = false, .a_to = sign > 0 ? a : b, .a_from = {}, .b_to = sign > 0 ? b : a, .b_from = {}, .origin = origin};
}

/// The plane through `origin` parallel to the edge from -> to and to the axis. Its inner side is given by `sign`: the sign
/// with which the first of the edge's two planes rises along the axis.
[[nodiscard]] inline ExactPlane outline_plane(const Vec3& from, const Vec3& to, const Vec3& axis, int sign,
                                              const Vec3& origin) {
  if (sign > 0) return {.direct = false, .a_to = to, .a_from = from, .b_to = axis, .b_from = {}, .origin = origin};
  return {.direct = false, .a_to = axis, .a_from = {}, .b_to = to, .b_from = from, .origin = origin};
}

/// Visits the planes of the profile along axis k until `visit(recipe)` is true; returns whether it was. `sign_along(plane,
/// k)` is the exact sign of the dot product of axis k and the normal of a plane of the frustum.
template <class SignAlong, class Visit>
[[nodiscard]] bool visit_outline(const StoredFrustum& frustum, const BoxAxes& axes, std::size_t k,
                                 const SignAlong& sign_along, const Visit& visit) {
  const Vec3& axis = axes.directions[k];
  const auto& corners = frustum.silhouette;
  const std::size_t sides = frustum.near_count, n = corners.size();
  const Viewpoint& viewpoint = frustum.viewpoint;
  for (std::size_t i = 0; i < n; ++i) {
    const int before = sign_along(sides + (i + n - 1) % n, k), after = sign_along(sides + i, k);
    if (before * after >= 0) continue;
    if (visit(viewpoint.is_eye() ? outline_plane(viewpoint.value, corners[i], axis, before, viewpoint.value)
                                 : outline_plane({}, viewpoint.value, axis, before, corners[i]))) {
      return true;
    }
  }
  for (const auto& [from, to, left, right] : frustum.cap_edges) {
    const int sign = sign_along(left, k);
    if (sign * sign_along(right, k) < 0 && visit(outline_plane(from, to, axis, sign, from))) return true;
  }
  for (std::size_t i = 0; frustum.is_cut() && i < n; ++i) {
    if (sign_along(0, k) * sign_along(sides + i, k) >= 0) continue;
    if (visit(CutEdgePlane{static_cast<std::uint32_t>(sides + i), axis})) return true;
  }
  return false;
}

/// Whether the normal of `face` goes along the ray of a corner, or across it.
[[nodiscard]] inline bool goes_along(const StoredFrustum& frustum, const ExactPlane& face, std::size_t corner) {
  return certified(
      [&]<class A>(A& arithmetic) { return arithmetic.sign(dot(normal<A>(face), ray<A>(frustum, corner))) >= 0; });
}

/// Whether the frustum has a vertex on the ray of a corner at which the near plane cuts it, and its normal goes along the
/// two edges of the near side that leave from there.
[[nodiscard]] inline bool is_lowest_cut_vertex(const StoredFrustum& frustum, const ExactPlane& face, std::size_t corner) {
  const std::size_t sides = frustum.near_count, n = frustum.silhouette.size();
  return certified([&]<class A>(A& arithmetic) {
    const auto near = normal<A>(plane_of(frustum, 0)), m = normal<A>(face);
    if (arithmetic.sign(dot(near, ray<A>(frustum, corner))) <= 0) return false;
    const auto next = cross(normal<A>(plane_of(frustum, sides + corner)), near);
    const auto previous = cross(near, normal<A>(plane_of(frustum, sides + (corner + n - 1) % n)));
    return arithmetic.sign(dot(m, next)) >= 0 && arithmetic.sign(dot(m, previous)) >= 0;
  });
}

/// The plane with the normal of `face` on which the frustum stands, if it is bounded that way.
[[nodiscard]] inline std::optional<PlaneRecipe> standing_plane(const StoredFrustum& frustum, ExactPlane face) {
  const auto& corners = frustum.silhouette;
  if (frustum.is_cut()) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (!goes_along(frustum, face, i) || !is_lowest_cut_vertex(frustum, face, i)) continue;
      face.origin = corners[i];
      return CutVertexPlane{static_cast<std::uint32_t>(i), face};
    }
    return std::nullopt;
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (!goes_along(frustum, face, i)) return std::nullopt;
  }
  face.origin = frustum.cap_vertices[0];
  for (const Vec3& v : frustum.cap_vertices) {
    if (sign_at(face, v) < 0) face.origin = v;
  }
  return face;
}

/// Visits all planes of the profile in the same way as visit_outline().
template <class SignAlong, class Visit>
[[nodiscard]] bool visit_profile(const StoredFrustum& frustum, const BoxAxes& axes, const SignAlong& sign_along,
                                 const Visit& visit) {
  for (std::size_t k = 0; k < 3; ++k) {
    for (const int sign : {1, -1}) {
      const auto plane = standing_plane(frustum, face_plane(axes, k, sign, frustum.silhouette[0]));
      if (plane && visit(*plane)) return true;
    }
    if (visit_outline(frustum, axes, k, sign_along, visit)) return true;
  }
  return false;
}

}  // namespace occlude::kernel
