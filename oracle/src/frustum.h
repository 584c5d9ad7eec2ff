// SPDX-License-Identifier: MIT
// The shadow frustum F of a polygon, as the definition states it: one half-space a side and one for the near plane.
#pragma once

#include <span>
#include <vector>

#include "plane.h"

namespace occlude::oracle {

/// A polygon and what it is seen from. Views: the caller's data must outlive this.
struct Scene {
  const Viewpoint& view;
  std::span<const Point> loop;
  const Near& near;

  [[nodiscard]] const Point& next(std::size_t i) const { return loop[i + 1 == loop.size() ? 0 : i + 1]; }
};

/// The plane through the viewpoint and the edge from vertex `edge` to the next: height(x) is det(s_i - V, s_(i+1) - V, x -
/// V), or det(d, s_(i+1) - s_i, x - s_i) for a direction d. All zero for an edge seen as a point.
template <class N>
HalfSpace<N> side_plane(const Scene& scene, std::size_t edge) {
  const Point &eye = scene.view.value, &a = scene.loop[edge], &b = scene.next(edge);
  if (scene.view.at_infinity) return {CGAL::cross_product(vector_of<N>(eye), difference<N>(a, b)), vector_of<N>(a)};
  return {CGAL::cross_product(difference<N>(eye, a), difference<N>(eye, b)), vector_of<N>(eye)};
}

/// Twice the vector area of the loop: the normal of the plane of a coplanar polygon.
template <class N>
Vector<N> vector_area(const Scene& scene) {
  Vector<N> sum(N(0), N(0), N(0));
  const Point& origin = scene.loop[0];
  for (std::size_t i = 1; i + 1 < scene.loop.size(); ++i) {
    sum = sum + CGAL::cross_product(difference<N>(origin, scene.loop[i]), difference<N>(origin, scene.loop[i + 1]));
  }
  return sum;
}

/// The direction in which `x` is seen.
template <class N>
Vector<N> sight(const Scene& scene, const Point& x) {
  return scene.view.at_infinity ? vector_of<N>(scene.view.value) : difference<N>(scene.view.value, x);
}

/// How plane `index` of F is defined: the sides first, the near plane last.
struct PlaneOfFrustum {
  Scene scene;
  CGAL::Sign turn;
  std::size_t index;
  std::size_t farthest;  ///< vertex of the near plane `farthest`

  template <class N>
  HalfSpace<N> operator()() const;
};

/// The half-spaces of F. The scene must be without fault (see faults.h).
class Frustum {
 public:
  /// `turn` is POSITIVE when the side planes have the polygon on their positive side as the loop goes, else NEGATIVE.
  Frustum(const Scene& scene, CGAL::Sign turn);

  std::vector<Plane<PlaneOfFrustum>>& planes() { return planes_; }
  Plane<PlaneOfFrustum>& near_plane() { return planes_.back(); }

 private:
  std::vector<Plane<PlaneOfFrustum>> planes_;
};

}  // namespace occlude::oracle
