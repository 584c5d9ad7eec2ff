// SPDX-License-Identifier: MIT
#include "farthest.h"

#include "half_spaces.h"

namespace occlude::oracle {
namespace {

/// A measure of how far `x` is from the viewpoint, for comparison only: the squared distance from the eye, or the scalar
/// product with the direction.
template <class N>
N remoteness(const Viewpoint& view, const Point& x) {
  const Vector<N> to_vertex = sight<N>(view, x);
  return to_vertex * (view.at_infinity ? vector_of<N>(x) : to_vertex);
}

}  // namespace

Point farthest_of(const Viewpoint& view, std::span<const Point> vertices) {
  Point best = vertices[0];
  for (const Point& vertex : vertices) {
    const auto lead = [&]<class N>() { return N(remoteness<N>(view, vertex) - remoteness<N>(view, best)); };
    if (sign_of(lead) == CGAL::POSITIVE) best = vertex;
  }
  return best;
}

}  // namespace occlude::oracle
