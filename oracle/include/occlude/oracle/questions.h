// SPDX-License-Identifier: MIT
// The kernel's other questions, judged as those of oracle.h are: boxes against view frusta, the silhouette, and how two
// convex objects lie to each other as they are seen.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "occlude/oracle/oracle.h"

namespace occlude::oracle {

/// The closed half-space a*x + b*y + c*z + d >= 0.
using HalfSpaceCoefficients = std::array<double, 4>;

/// Relation of `box` to the intersection of the half-spaces, which may be empty: then it is outside.
[[nodiscard]] Answer relation_to_half_spaces(std::span<const HalfSpaceCoefficients> half_spaces, const Box& box);

/// The silhouette of an occluder, or why there is none.
struct Outline {
  std::string refusal;
  /// The vertices of the silhouette at which it turns, in lexicographic order, no position twice. Of a polygon that is not
  /// coplanar two may be seen as one: both are there.
  std::vector<Point> corners;
  Point farthest{};  ///< of all its vertices, the first in the input of equally far ones
};

[[nodiscard]] Outline outline(const Viewpoint& view, const Occluder& occluder);

/// Relation of the cone of the rays from the viewpoint that meet the occludee to the cone of those that meet the occluder:
/// inside when it is a subset, outside when they share no ray.
[[nodiscard]] Answer cone_relation(const Viewpoint& view, const Occluder& occluder, const Occluder& occludee);

}  // namespace occlude::oracle
