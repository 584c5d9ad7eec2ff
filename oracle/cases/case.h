// SPDX-License-Identifier: MIT
// A case of the kernel's question, with any kind of occluder and box.
#pragma once

#include <variant>
#include <vector>

#include "occlude/kernel/region_shadow.h"
#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/types.h"

namespace occlude::cases {

using kernel::Near;

/// The vertices of a convex polygon in order.
using Polygon = std::vector<kernel::Vec3>;
using Occluder = std::variant<Polygon, kernel::Polytope>;
using Box = std::variant<kernel::Aabb, kernel::Obb>;

/// One question: what is the relation of `box` to the shadow frustum of `occluder` seen from `viewpoint`?
struct Case {
  kernel::Viewpoint viewpoint;
  Occluder occluder;
  Near near = Near::farthest;
  Box box;
};

/// What is the relation of `box` to the umbra or penumbra of `occluder` for a region of viewpoints?
struct RegionCase {
  kernel::ViewRegion region;
  kernel::ShadowKind kind = kernel::ShadowKind::umbra;
  Occluder occluder;
  Box box;
};

[[nodiscard]] inline std::vector<kernel::Vec3>& vertices_of(Occluder& occluder) {
  auto* const polygon = std::get_if<Polygon>(&occluder);
  return polygon ? *polygon : std::get<kernel::Polytope>(occluder).vertices;
}
[[nodiscard]] inline const std::vector<kernel::Vec3>& vertices_of(const Occluder& occluder) {
  const auto* const polygon = std::get_if<Polygon>(&occluder);
  return polygon ? *polygon : std::get<kernel::Polytope>(occluder).vertices;
}

}  // namespace occlude::cases
