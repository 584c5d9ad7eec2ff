// SPDX-License-Identifier: MIT
#include "occludee.h"

#include <algorithm>

namespace occlude::oracle {

Aabb bounding_box(std::span<const Point> points) {
  Aabb box{points[0], points[0]};
  for (const Point& p : points) {
    for (std::size_t k = 0; k < 3; ++k) {
      box.min[k] = std::min(box.min[k], p[k]);
      box.max[k] = std::max(box.max[k], p[k]);
    }
  }
  return box;
}

Relation relate(const Planes& planes, const Solid& solid) {
  const auto is_within = [&](Plane<OrientedPlane>* plane) {
    return std::ranges::all_of(solid.points, [&](const Point& p) { return plane->side(p) != CGAL::NEGATIVE; });
  };
  if (std::ranges::all_of(planes, is_within)) return Relation::inside;
  std::vector<Plane<OrientedPlane>> faces;
  for (std::size_t f = 0; f < solid.faces.size(); ++f) faces.emplace_back(solid.half_space(f));
  Planes all = planes;
  append(all, faces);
  return share_a_point(all, bounding_box(solid.points)) ? Relation::partial : Relation::outside;
}

}  // namespace occlude::oracle
