// SPDX-License-Identifier: MIT
// The planes that bound the umbra and the penumbra of a convex occluder (region_shadow.h).
//
// Seen from a point x, the eyes from which the occluder hides x are a convex set. So the umbra of a region is the
// intersection of the shadows from its corners. Of these a few planes are left:
// - The near side: every face turned to some corner.
// - The sides: edges between a face turned to some corner and one that is turned to none. From each corner to which that
//   face is turned there is one side plane through the edge. They turn about the edge, and beyond the face they are ordered:
//   of two, one has the other's corner on its inner side, and is the tighter. So the tightest has all eyes on its inner
//   side. Side planes from the other corners, and through the edges between two turned faces, cut off nothing that the near
//   side leaves.
//
// A point of the penumbra is (1 + t) o - t e with a point o of the occluder, an eye e and t >= 0. These points are the sum
// of the occluder and of the cone of the directions o - e. It is bounded by
// - the near side: faces turned to all corners;
// - planes that touch both occluder and region, which lie on different sides of them: through an edge of the occluder and a
//   corner of the region, or through a vertex and an edge of the region.
#pragma once

#include <cstdint>
#include <memory_resource>
#include <vector>

#include "occlude/kernel/region_shadow.h"
#include "planes.h"

namespace occlude::kernel {

/// A convex polytope, or a polygon as a polytope of two faces. The inner side of a face's plane is that of the polytope. An
/// edge runs counter-clockwise around `left`, seen from outside.
struct OccluderSurface {
  struct Edge {
    Vec3 from, to;
    std::uint32_t left, right;  ///< indices of faces
  };

  explicit OccluderSurface(std::pmr::memory_resource& memory) : faces(&memory), edges(&memory), vertices(&memory) {}

  std::pmr::vector<ExactPlane> faces;
  std::pmr::vector<Edge> edges;
  std::pmr::vector<Vec3> vertices;
};

/// The corners of a region. Half edges of zero do not double them.
[[nodiscard]] std::pmr::vector<RegionCorner> corners_of(const ViewRegion& region, std::pmr::memory_resource& memory);

/// Sign of a plane at a corner of a region; for a direction of view, at the eye at infinity from which it comes.
[[nodiscard]] int sign_at(const ExactPlane& plane, const RegionCorner& corner);

/// The planes of the near side, and the others.
struct RegionPlanes {
  explicit RegionPlanes(std::pmr::memory_resource& memory) : near(&memory), sides(&memory) {}

  std::pmr::vector<PlaneRecipe> near, sides;
};

/// REQUIRES: the region does not meet the occluder, nor its plane if it is a polygon.
[[nodiscard]] RegionPlanes region_planes(const OccluderSurface& occluder, const ViewRegion& region, ShadowKind kind,
                                         std::pmr::memory_resource& memory);

}  // namespace occlude::kernel
