// SPDX-License-Identifier: MIT
#include "naive.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "vector_math.h"

namespace occlude::bench {
namespace {

using kernel::Aabb;
using kernel::Relation;

using Corners = std::array<Vec3, 8>;
using Edge = std::array<std::size_t, 2>;

/// The edges of a box. The indices are those of corner(box, i).
constexpr std::array<Edge, 12> kBoxEdges{
    {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
/// The faces of a box: two per axis, the lower one first.
constexpr std::array<BoundedFrustum::Face, 6> kBoxFaces{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
/// The edges of a frustum. Those of the near and of the far face run round in the same sense. So whichever corner is in a
/// box, an edge leads into the box at this corner or before it.
constexpr std::array<Edge, 12> kFrustumEdges{
    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

int longest_axis(const Vec3& v) {
  const double x = std::fabs(v.x), y = std::fabs(v.y), z = std::fabs(v.z);
  return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

NaiveFace make_face(const Corners& corners, const BoundedFrustum::Face& face) {
  const std::array quad{corners[face[0]], corners[face[1]], corners[face[2]], corners[face[3]]};
  const Vec3 normal = cross(quad[1] - quad[0], quad[3] - quad[0]);
  return {quad, normal, longest_axis(normal)};
}

double height(const NaiveFace& face, const Vec3& x) { return dot(face.normal, x - face.corners[0]); }

/// The edge-face test: finds the point where the edge meets the plane of the face, then the side of the face's four edges on
/// which the point lies.
bool meet(const Vec3& from, const Vec3& to, const NaiveFace& face) {
  const double at_from = height(face, from), at_to = height(face, to);
  if (at_from * at_to > 0 || at_from == at_to) return false;
  const Vec3 point = from + (at_from / (at_from - at_to)) * (to - from);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3& corner = face.corners[i];
    const Vec3 turn = cross(face.corners[(i + 1) % 4] - corner, point - corner);
    if (turn[face.axis] * face.normal[face.axis] < 0) return false;
  }
  return true;
}

Relation by_vertices(const NaiveFrustum& frustum, const Corners& box) {
  bool inside = true;
  for (const NaiveFace& face : frustum.faces) {
    std::size_t outer = 0;
    for (const Vec3& corner : box) outer += height(face, corner) > 0 ? 1U : 0U;
    if (outer == box.size()) return Relation::outside;
    inside = inside && outer == 0;
  }
  return inside ? Relation::inside : Relation::partial;
}

bool contains(const Aabb& box, const Vec3& x) {
  return x.x >= box.min.x && x.x <= box.max.x && x.y >= box.min.y && x.y <= box.max.y && x.z >= box.min.z &&
         x.z <= box.max.z;
}

bool box_edges_meet(const NaiveFrustum& frustum, const Corners& box) {
  return std::ranges::any_of(kBoxEdges, [&](const Edge& edge) {
    return std::ranges::any_of(frustum.faces, [&](const NaiveFace& face) { return meet(box[edge[0]], box[edge[1]], face); });
  });
}

bool frustum_edges_meet(const NaiveFrustum& frustum, const Corners& box) {
  return std::ranges::any_of(kFrustumEdges, [&](const Edge& edge) {
    const Vec3 from = frustum.corners[edge[0]], to = frustum.corners[edge[1]];
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t entered = 2 * static_cast<std::size_t>(axis) + (to[axis] < from[axis] ? 1 : 0);
      if (meet(from, to, make_face(box, kBoxFaces[entered]))) return true;
    }
    return false;
  });
}

}  // namespace

NaiveFrustum::NaiveFrustum(const BoundedFrustum& frustum) : corners(frustum.corners), faces() {
  for (std::size_t i = 0; i < faces.size(); ++i) faces[i] = make_face(corners, BoundedFrustum::kFaces[i]);
}

Relation naive_overlap(const NaiveFrustum& frustum, const Aabb& box) {
  Corners corners;
  for (unsigned i = 0; i < 8; ++i) corners[i] = corner(box, i);
  const Relation relation = by_vertices(frustum, corners);
  if (relation != Relation::partial) return relation;
  const bool meets =
      contains(box, frustum.corners[0]) || box_edges_meet(frustum, corners) || frustum_edges_meet(frustum, corners);
  return meets ? Relation::partial : Relation::outside;
}

}  // namespace occlude::bench
