// SPDX-License-Identifier: MIT
#include "true_plane.h"

#include <variant>

namespace occlude::bound_check {
namespace {

TruePlane through(const Vector& point, const Vector& normal) { return {normal, -(normal * point)}; }

Vector normal_of(const kernel::ExactPlane& plane) {
  const Vector a = vector_of(plane.a_to) - vector_of(plane.a_from);
  return plane.direct ? a : CGAL::cross_product(a, vector_of(plane.b_to) - vector_of(plane.b_from));
}

TruePlane build(const kernel::StoredFrustum&, const kernel::ExactPlane& plane) {
  return through(vector_of(plane.origin), normal_of(plane));
}

TruePlane build(const kernel::StoredFrustum& frustum, const kernel::CutEdgePlane& plane) {
  const TruePlane near = true_plane(frustum, frustum.recipes[0]), side = true_plane(frustum, frustum.recipes[plane.side]);
  const Vector axis = vector_of(plane.axis);
  const TruePlane a = scaled(near, CGAL::abs(side.normal * axis)), b = scaled(side, CGAL::abs(near.normal * axis));
  return {a.normal + b.normal, a.offset + b.offset};
}

TruePlane build(const kernel::StoredFrustum& frustum, const kernel::CutVertexPlane& plane) {
  const kernel::Viewpoint& viewpoint = frustum.viewpoint;
  const TruePlane near = true_plane(frustum, frustum.recipes[0]);
  const kernel::Vec3& corner = frustum.silhouette[plane.corner];
  const Vector ray = vector_of(viewpoint.value);
  const Vector along = viewpoint.is_eye() ? vector_of(corner) - ray : ray;
  const Exact speed = near.normal * along;
  const Vector vertex = vector_of(corner) - near.at(corner) / speed * along;
  return scaled(through(vertex, normal_of(plane.face)), speed);
}

TruePlane build(const kernel::StoredFrustum&, const kernel::SightPlane& plane) {
  Vector corner = vector_of(plane.corner.at);
  for (const kernel::Vec3& move : plane.corner.moves) corner = corner + vector_of(move);
  const Vector sight = plane.corner.is_eye ? vector_of(plane.point) - corner : corner;
  return through(vector_of(plane.point), CGAL::cross_product(sight, vector_of(plane.to) - vector_of(plane.from)));
}

}  // namespace

TruePlane true_plane(const kernel::StoredFrustum& frustum, const kernel::PlaneRecipe& recipe) {
  return std::visit([&](const auto& plane) { return build(frustum, plane); }, recipe);
}

TruePlane scaled(const TruePlane& plane, const Exact& factor) { return {factor * plane.normal, factor * plane.offset}; }

Range values(const TruePlane& plane, const kernel::Aabb& box) {
  Range range{plane.offset, plane.offset};
  for (int k = 0; k < 3; ++k) {
    const Exact a = plane.normal[k] * Exact(box.min[k]), b = plane.normal[k] * Exact(box.max[k]);
    range.low += a < b ? a : b;
    range.high += a < b ? b : a;
  }
  return range;
}

Range values(const TruePlane& plane, const kernel::Obb& box) {
  const Exact center = plane.at(box.center);
  Exact spread = 0;
  for (const kernel::Vec3& half_edge : box.half_edges) spread += CGAL::abs(plane.normal * vector_of(half_edge));
  return {center - spread, center + spread};
}

}  // namespace occlude::bound_check
