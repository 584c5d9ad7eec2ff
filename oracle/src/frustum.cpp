// SPDX-License-Identifier: MIT
#include "frustum.h"

#include "farthest.h"
#include "faults.h"
#include "loop.h"

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

}  // namespace occlude::oracle
