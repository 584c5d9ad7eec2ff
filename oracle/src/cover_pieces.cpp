// SPDX-License-Identifier: MIT
// Points are relative to the viewpoint: to an eye, or to any point for a direction d.
//
// A triangle that is not seen edge-on has one piece: the inner sides of the planes through its edges and the viewpoint,
// beyond the plane of the triangle.
//
// A ray meets a triangle seen edge-on first on its edges. The shadow of an edge is flat: it lies in the plane of the edge
// and the viewpoint, between the rays to the ends of the edge, beyond the edge. A ray meets an edge that lies along it first
// at an end. The shadow of that end is the rest of the ray.
//
// A triangle that contains the eye hides every point of its plane between the rays to the ends of any edge that does not
// contain the eye, and on the rays to its corners.
#include "cover_pieces.h"

#include <algorithm>
#include <array>

namespace occlude::oracle {
namespace {

template <class N>
class Pieces {
  using V = Vector<N>;
  using Edge = std::array<V, 2>;

 public:
  Pieces(const Viewpoint& view, const std::optional<HalfSpaceCoefficients>& drawn)
      : is_eye_(!view.at_infinity),
        origin_(is_eye_ ? vector_of<N>(view.value) : V(N(0), N(0), N(0))),
        direction_(vector_of<N>(view.value)) {
    if (drawn) {
      const V normal = vector_of<N>({(*drawn)[0], (*drawn)[1], (*drawn)[2]});
      drawn_ = {normal, V(N(0), N(0), N(0)), normal * origin_ + N((*drawn)[3])};
    }
  }

  void add(const Point& p, const Point& q, const Point& r) {
    const V a = vector_of<N>(p) - origin_, b = vector_of<N>(q) - origin_, c = vector_of<N>(r) - origin_;
    const V normal = CGAL::cross_product(b - a, c - a);
    const CGAL::Sign faces = certain_sign(is_eye_ ? N(normal * a) : N(normal * direction_));
    if (faces == CGAL::ZERO) {
      if (!drawn_) add_edge_on({a, b, c});
    } else {
      add_triangle(a, faces == CGAL::POSITIVE ? b : c, faces == CGAL::POSITIVE ? c : b);
    }
  }

  std::vector<ShadowPiece<N>> take() { return std::move(pieces_); }

 private:
  static bool is_zero(const V& v) {
    return certain_sign(v.x()) == CGAL::ZERO && certain_sign(v.y()) == CGAL::ZERO && certain_sign(v.z()) == CGAL::ZERO;
  }
  /// Normal of the plane that contains the rays to `a` and `b`. Exchanging the two reverses it.
  V across(const V& a, const V& b) const { return CGAL::cross_product(is_eye_ ? a : direction_, is_eye_ ? b : V(b - a)); }
  HalfSpace<N> above(const V& normal, const N& height) const { return {normal, origin_, -height}; }
  HalfSpace<N> through(const V& normal, const V& point) const { return above(normal, normal * point); }
  static void add_plane(ShadowPiece<N>& piece, const HalfSpace<N>& half_space) {
    piece.closed.push_back(half_space);
    piece.closed.push_back({-half_space.normal, half_space.point, -half_space.offset});
  }

  /// REQUIRES: the normal of the triangle, by the order of its corners, points away from the viewpoint.
  void add_triangle(const V& a, const V& b, const V& c) {
    const V normal = CGAL::cross_product(b - a, c - a);
    ShadowPiece<N> piece;
    for (const Edge& edge : {Edge{a, b}, {b, c}, {c, a}}) piece.closed.push_back(through(across(edge[0], edge[1]), edge[0]));
    piece.open.push_back(through(normal, a));
    if (drawn_) piece.closed.push_back(meeting_is_drawn(normal, N(normal * a)));
    pieces_.push_back(std::move(piece));
  }

  /// The points x whose line of sight meets the plane normal . y = height at a point y that is in `drawn`. From an eye, y =
  /// x height / (normal . x). For a direction, y = x - direction (normal . x - height) / (normal . direction). Both
  /// denominators are positive in the shadow, so the condition on y is multiplied by them.
  HalfSpace<N> meeting_is_drawn(const V& normal, const N& height) const {
    const V& n = drawn_->normal;
    const N& offset = drawn_->offset;
    if (is_eye_) return above(offset * normal + height * n, N(0));
    const N along = normal * direction_, drawn_along = n * direction_;
    return above(along * n - drawn_along * normal, N(-(along * offset + drawn_along * height)));
  }

  void add_edge_on(const std::array<V, 3>& corners) {
    const auto& [a, b, c] = corners;
    const std::array<Edge, 3> edges{Edge{a, b}, {b, c}, {c, a}};
    const bool is_at_eye = is_eye_ && (std::ranges::any_of(edges, holds_eye) || surrounds_eye(corners));
    for (const Edge& edge : edges) {
      if (!is_eye_ || !holds_eye(edge)) add_edge(edge, is_at_eye);
    }
    if (!is_at_eye) return;
    for (const V& corner : corners) {
      if (!is_zero(corner)) add_ray(corner, N(0));
    }
  }

  static bool holds_eye(const Edge& edge) {
    return is_zero(CGAL::cross_product(edge[0], edge[1])) && certain_sign(N(edge[0] * edge[1])) != CGAL::POSITIVE;
  }
  static bool surrounds_eye(const std::array<V, 3>& corners) {
    const V ab = CGAL::cross_product(corners[0], corners[1]), bc = CGAL::cross_product(corners[1], corners[2]),
            ca = CGAL::cross_product(corners[2], corners[0]);
    return certain_sign(N(ab * bc)) == CGAL::POSITIVE && certain_sign(N(bc * ca)) == CGAL::POSITIVE;
  }

  void add_edge(const Edge& edge, bool is_at_eye) {
    const auto& [a, b] = edge;
    const V normal = across(a, b);
    if (is_zero(normal)) {
      const V& along = is_eye_ ? a : direction_;
      const bool is_a_nearer = certain_sign(N(along * (b - a))) != CGAL::NEGATIVE;
      add_ray(is_a_nearer ? a : b, is_at_eye ? N(0) : N(along * (is_a_nearer ? a : b)));
      return;
    }
    ShadowPiece<N> piece;
    add_plane(piece, through(normal, a));
    piece.closed.push_back(through(inwards(normal, a), a));
    piece.closed.push_back(through(-inwards(normal, b), b));
    // It points away from the viewpoint, lies in the plane and is perpendicular to the edge.
    V away = CGAL::cross_product(b - a, normal);
    const CGAL::Sign sign = certain_sign(N(away * (is_eye_ ? a : direction_)));
    if (sign == CGAL::NEGATIVE) away = -away;
    piece.open.push_back(above(away, is_at_eye ? N(0) : N(away * a)));
    pieces_.push_back(std::move(piece));
  }
  /// Lies in the plane with that normal, perpendicular to the ray to `point`.
  V inwards(const V& normal, const V& point) const { return CGAL::cross_product(normal, is_eye_ ? point : direction_); }

  /// Adds the part of the ray through `point` on which along . x > height.
  void add_ray(const V& point, const N& height) {
    const V& along = is_eye_ ? point : direction_;
    ShadowPiece<N> piece;
    for (int axis = 0; axis < 3; ++axis) {
      const V unit(N(axis == 0 ? 1 : 0), N(axis == 1 ? 1 : 0), N(axis == 2 ? 1 : 0));
      add_plane(piece, through(CGAL::cross_product(unit, along), point));
    }
    piece.open.push_back(above(along, height));
    pieces_.push_back(std::move(piece));
  }

  bool is_eye_;
  V origin_, direction_;
  std::optional<HalfSpace<N>> drawn_;  ///< in coordinates relative to origin_
  std::vector<ShadowPiece<N>> pieces_;
};

}  // namespace

template <class N>
std::vector<ShadowPiece<N>> pieces_of(const Viewpoint& view, const std::vector<Loop>& polygons,
                                      const std::optional<HalfSpaceCoefficients>& drawn) {
  Pieces<N> pieces(view, drawn);
  for (const Loop& polygon : polygons) {
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) pieces.add(polygon[0], polygon[i], polygon[i + 1]);
  }
  return pieces.take();
}

template std::vector<ShadowPiece<Interval>> pieces_of<Interval>(const Viewpoint&, const std::vector<Loop>&,
                                                                const std::optional<HalfSpaceCoefficients>&);
template std::vector<ShadowPiece<Exact>> pieces_of<Exact>(const Viewpoint&, const std::vector<Loop>&,
                                                          const std::optional<HalfSpaceCoefficients>&);

}  // namespace occlude::oracle
