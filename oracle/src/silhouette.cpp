// SPDX-License-Identifier: MIT
#include "silhouette.h"

#include <algorithm>
#include <iterator>

namespace occlude::oracle {
namespace {

bool is_turned_to(const Viewpoint& view, const OrientedPlane& half_space) {
  const auto depth = [&]<class N>() -> N {
    const HalfSpace<N> face = half_space.operator()<N>();
    return view.at_infinity ? N(-(face.normal * vector_of<N>(view.value))) : face.height(view.value);
  };
  return sign_of(depth) == CGAL::NEGATIVE;
}

}  // namespace

std::vector<bool> turned_faces(const Viewpoint& view, const Solid& solid) {
  std::vector<bool> is_turned;
  for (std::size_t f = 0; f < solid.faces.size(); ++f) is_turned.push_back(is_turned_to(view, solid.half_space(f)));
  return is_turned;
}

std::vector<Point> silhouette_vertices(const Solid& solid, const std::vector<bool>& is_turned,
                                       const std::vector<Point>& vertices) {
  std::vector<Plane<LoopPlane>> planes;
  for (const Loop& face : solid.faces) planes.emplace_back(LoopPlane{face});
  const auto lies_on_face = [&](const Point& vertex, bool turned) {
    for (std::size_t f = 0; f < planes.size(); ++f) {
      if (is_turned[f] == turned && planes[f].side(vertex) == CGAL::ZERO) return true;
    }
    return false;
  };
  std::vector<Point> silhouette;
  std::ranges::copy_if(vertices, std::back_inserter(silhouette),
                       [&](const Point& vertex) { return lies_on_face(vertex, true) && lies_on_face(vertex, false); });
  return silhouette;
}

std::vector<OrientedPlane> side_planes(const Viewpoint& view, const Solid& solid) {
  const std::vector<Point>& points = solid.points;
  std::vector<OrientedPlane> sides;
  // For each point, the sides on which it lies. Two points that share a side do not span another.
  std::vector<std::vector<std::size_t>> sides_at(points.size());
  const auto share_a_side = [&](std::size_t i, std::size_t j) {
    return std::ranges::any_of(sides_at[i], [&](std::size_t side) { return std::ranges::binary_search(sides_at[j], side); });
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (share_a_side(i, j)) continue;
      const SidePlane side{view, points[i], points[j]};
      const CGAL::Sign interior = side_of_all(side, points);
      if (interior == CGAL::ZERO) continue;
      Plane<SidePlane> plane(side);
      for (std::size_t k = 0; k < points.size(); ++k) {
        if (plane.side(points[k]) == CGAL::ZERO) sides_at[k].push_back(sides.size());
      }
      sides.push_back({side, interior});
    }
  }
  return sides;
}

}  // namespace occlude::oracle
