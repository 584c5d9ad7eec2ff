// SPDX-License-Identifier: MIT
#include "frustum.h"

namespace occlude::oracle {
namespace {

/// How far vertex `i` lies from the viewpoint, for comparison: the squared distance from the eye, or the way along d.
template <class N>
N remoteness(const Scene& scene, std::size_t i) {
  const Vector<N> to_vertex = sight<N>(scene, scene.loop[i]);
  return scene.view.at_infinity ? N(to_vertex * vector_of<N>(scene.loop[i])) : N(to_vertex * to_vertex);
}

/// Index of the vertex farthest from the viewpoint, the lowest on a tie.
std::size_t farthest_vertex(const Scene& scene) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < scene.loop.size(); ++i) {
    const auto lead = [&]<class N>() { return N(remoteness<N>(scene, i) - remoteness<N>(scene, best)); };
    if (sign_of(lead) == CGAL::POSITIVE) best = i;
  }
  return best;
}

template <class N>
HalfSpace<N> oriented(const HalfSpace<N>& plane, CGAL::Sign turn) {
  return turn == CGAL::NEGATIVE ? HalfSpace<N>{-plane.normal, plane.point} : plane;
}

template <class N>
HalfSpace<N> near_plane(const PlaneOfFrustum& plane) {
  const Scene& scene = plane.scene;
  switch (scene.near.kind) {
    case Near::Kind::farthest: {
      const Point& p = scene.loop[plane.farthest];
      return {sight<N>(scene, p), vector_of<N>(p)};
    }
    case Near::Kind::surface:
      return oriented(HalfSpace<N>{vector_area<N>(scene), vector_of<N>(scene.loop[0])}, plane.turn);
    case Near::Kind::plane:
      break;
  }
  return {vector_of<N>(scene.near.normal), vector_of<N>(scene.near.point)};
}

}  // namespace

template <class N>
HalfSpace<N> PlaneOfFrustum::operator()() const {
  return index < scene.loop.size() ? oriented(side_plane<N>(scene, index), turn) : near_plane<N>(*this);
}
template HalfSpace<Interval> PlaneOfFrustum::operator()() const;
template HalfSpace<Exact> PlaneOfFrustum::operator()() const;

Frustum::Frustum(const Scene& scene, CGAL::Sign turn) {
  const std::size_t farthest = scene.near.kind == Near::Kind::farthest ? farthest_vertex(scene) : 0;
  planes_.reserve(scene.loop.size() + 1);
  for (std::size_t i = 0; i <= scene.loop.size(); ++i) planes_.emplace_back(PlaneOfFrustum{scene, turn, i, farthest});
}

}  // namespace occlude::oracle
