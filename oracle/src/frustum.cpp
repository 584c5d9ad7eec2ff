// SPDX-License-Identifier: MIT
#include "frustum.h"

#include <algorithm>

#include "farthest.h"
#include "faults.h"
#include "loop.h"
#include "polytope.h"
#include "silhouette.h"

namespace occlude::oracle {
namespace {

std::string near_fault(const Viewpoint& view, const Loop& loop, const Near& near) {
  if (near.kind == Near::Kind::plane) return plane_fault(view, loop, near);
  if (near.kind == Near::Kind::farthest || is_coplanar(loop)) return "";
  return "the vertices are not coplanar: give a support plane as near";
}

OrientedPlane near_plane(const Viewpoint& view, const Loop& loop, const Near& near, CGAL::Sign turn) {
  switch (near.kind) {
    case Near::Kind::farthest:
      return {FarthestPlane{view, farthest_of(view, loop)}};
    case Near::Kind::surface:
      return {LoopPlane{loop}, turn};
    case Near::Kind::plane:
      break;
  }
  return {GivenPlane{near.normal, near.point}};
}

std::vector<OrientedPlane> near_planes(const Viewpoint& view, const Solid& solid, const std::vector<bool>& is_turned,
                                       const std::vector<Point>& vertices, const Near& near) {
  std::vector<OrientedPlane> planes;
  switch (near.kind) {
    case Near::Kind::farthest:
      planes.push_back({FarthestPlane{view, farthest_of(view, silhouette_vertices(solid, is_turned, vertices))}});
      break;
    case Near::Kind::surface:
      for (std::size_t f = 0; f < solid.faces.size(); ++f) {
        if (is_turned[f]) planes.push_back(solid.half_space(f));
      }
      break;
    case Near::Kind::plane:
      planes.push_back({GivenPlane{near.normal, near.point}});
  }
  return planes;
}

}  // namespace

FrustumOrFault frustum_of(const Viewpoint& view, const Loop& loop, const Near& near) {
  Seen seen = see(view, loop);
  if (seen.fault.empty()) seen.fault = near_fault(view, loop, near);
  if (!seen.fault.empty()) return {{}, std::move(seen.fault)};
  Frustum frustum;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const SidePlane side{view, loop[i], loop[(i + 1) % loop.size()]};
    frustum.sides.emplace_back(OrientedPlane{side, seen.turn});
  }
  frustum.near.emplace_back(near_plane(view, loop, near, seen.turn));
  return {std::move(frustum), ""};
}

FrustumOrFault frustum_of(const Viewpoint& view, const Polytope& polytope, const Near& near) {
  auto [solid, fault] = solid_of(polytope);
  if (!fault.empty()) return {{}, std::move(fault)};
  const std::vector<bool> is_turned = turned_faces(view, solid);
  if (std::ranges::find(is_turned, true) == is_turned.end()) return {{}, "the eye lies in the polytope"};
  if (near.kind == Near::Kind::plane) fault = plane_fault(view, polytope.vertices, near);
  if (!fault.empty()) return {{}, std::move(fault)};
  Frustum frustum;
  for (const OrientedPlane& side : side_planes(view, solid)) frustum.sides.emplace_back(side);
  for (const OrientedPlane& plane : near_planes(view, solid, is_turned, polytope.vertices, near)) {
    frustum.near.emplace_back(plane);
  }
  return {std::move(frustum), ""};
}

}  // namespace occlude::oracle
