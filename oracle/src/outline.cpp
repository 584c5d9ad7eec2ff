// SPDX-License-Identifier: MIT
#include <algorithm>

#include "farthest.h"
#include "occlude/oracle/questions.h"
#include "prepared.h"
#include "silhouette.h"

namespace occlude::oracle {
namespace {

std::vector<Point> silhouette_of(const Viewpoint& view, const Occluder& occluder) {
  if (const Loop* loop = std::get_if<Loop>(&occluder)) return *loop;
  const Polytope& polytope = std::get<Polytope>(occluder);
  const Solid solid = solid_of(polytope).solid;
  return silhouette_vertices(solid, turned_faces(view, solid), polytope.vertices);
}

/// Whether two different planes through the line of sight to `v` have the whole silhouette on one side. A vertex that is
/// seen within an edge has only one such plane.
bool is_corner(const Viewpoint& view, const std::vector<Point>& silhouette, const Point& v) {
  std::vector<Point> neighbours;  // the vertices that share an edge with v, as seen
  for (const Point& u : silhouette) {
    if (side_of_all(SidePlane{view, v, u}, silhouette) != CGAL::ZERO) neighbours.push_back(u);
  }
  if (neighbours.empty()) return false;
  Plane edge(SidePlane{view, v, neighbours[0]});
  return std::ranges::any_of(neighbours, [&](const Point& u) { return edge.side(u) != CGAL::ZERO; });
}

}  // namespace

Outline outline(const Viewpoint& view, const Occluder& occluder) {
  const RoundUpward rounding;
  const Prepared prepared(view, occluder, {});
  if (!prepared.fault().empty()) return {prepared.fault(), {}, {}};
  std::vector<Point> silhouette = silhouette_of(view, occluder);
  Outline result{"", {}, farthest_of(view, silhouette)};
  std::ranges::sort(silhouette);
  silhouette.erase(std::unique(silhouette.begin(), silhouette.end()), silhouette.end());
  std::ranges::copy_if(silhouette, std::back_inserter(result.corners),
                       [&](const Point& v) { return is_corner(view, silhouette, v); });
  return result;
}

}  // namespace occlude::oracle
